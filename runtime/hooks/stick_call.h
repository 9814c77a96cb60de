// What the file calls of objects share: from a robot's path to the host's.
#pragma once

#include <string>

namespace openr_host {

enum class StickUse {
  kRead,    // an existing file or folder
  kChange,  // an existing one is changed
  kCreate,  // may be made, and is changed
};

// Where `path`, of the current object's stick, lies on the host.  Empty, with errno set and
// perhaps a finding, when the object may not have it.
std::string HostPath(const char* path, StickUse use);

}  // namespace openr_host
