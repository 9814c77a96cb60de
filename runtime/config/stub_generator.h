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
// names, guards, symbols and numbering of Sony's generator: selectors 0..3 for DoInit, DoStart,
// DoStop and DoDestroy, then Control of all subjects, Ready of all subjects, Connect of all
// observers, Notify of all observers, then the extra entries in file order.  The files are C++98,
// for the SDK's headers and for ours.  Their first comment names `source` ("stub.cfg"; without a
// folder, so that the output does not depend on the place of the file).
//
// The symbol openr_extra_names is our addition: the names of the extra entries in selector order,
// ended by 0.  A host shows these names in traces; on the robot the symbol has no effect.
//
// REQUIRES: `config` was parsed without an error.
std::vector<GeneratedFile> GenerateStub(const StubConfig& config, const std::string& source);

}  // namespace openr_host
