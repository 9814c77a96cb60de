// Generates the stub of an object: the four files that make a C++ class an OPEN-R object.
#pragma once

#include <string>
#include <vector>

#include "runtime/config/stub_config.h"

namespace openr_host {

struct GeneratedFile {
  std::string name;  // the file's name without its folder
  std::string text;
};

// Returns def.h, entry.h, <ObjectName>Stub.h and <ObjectName>Stub.cc, in this order, with the
// names, guards, symbols and numbering of Sony's generator.  The selectors 0..3 are DoInit,
// DoStart, DoStop and DoDestroy.  Then follow Control of all subjects, Ready of all subjects,
// Connect of all observers, Notify of all observers, and the extra entries in file order.  The
// files are C++98 and compile with the SDK's headers and with ours.  Their first comment names
// `source`, which is "stub.cfg" without a folder, so that the output does not depend on the place
// of the file.
//
// The symbol openr_extra_names is our addition: the names of the extra entries in selector order,
// ended by 0.  A host shows these names in traces; on the robot the symbol has no effect.
//
// REQUIRES: `config` was parsed without an error.
std::vector<GeneratedFile> GenerateStub(const StubConfig& config, const std::string& source);

}  // namespace openr_host
