// From a stub.cfg to the four files that make a core class an OPEN-R object.
#pragma once

#include <string>
#include <vector>

#include "runtime/config/stub_config.h"

namespace openr_host {

struct GeneratedFile {
  std::string name;  // without folder
  std::string text;
};

// Returns def.h, entry.h, <ObjectName>Stub.h and <ObjectName>Stub.cc, in this order, with the
// names, guards, symbols and numbering of Sony's generator: selectors 0..3 for the life cycle,
// then Control and Ready of each subject, Connect and Notify of each observer (all Controls, all
// Readys, and so on), then the extras in file order.  C++98, for the SDK's headers and for ours.
// `source` is named in the files' first comment ("stub.cfg"; no folder, so that output does
// not depend on where it was made).
//
// One symbol is ours: openr_extra_names, the extras' names in selector order, ended by 0.  A host
// reads it to name them in traces; elsewhere it is 4 bytes of no effect.
//
// REQUIRES: `config` was parsed without an error.
std::vector<GeneratedFile> GenerateStub(const StubConfig& config, const std::string& source);

}  // namespace openr_host
