// Converts paths of the robot to paths of the host, for the file functions of objects.
#pragma once

#include <string>

#include "runtime/core/object.h"

namespace openr_host {

enum class StickUse {
  kRead,    // reads an existing file or folder
  kChange,  // changes an existing file or folder
  kCreate,  // changes a file or folder, and creates it if it does not exist
};

// Returns the host's path for `path` on the stick of the current object.  If the object may not use
// the file in the way `use`, for instance because the stick is write-protected, returns "" and sets
// errno.  A mistake in `path`, such as a path outside of /MS, also causes a finding.
std::string HostPath(const char* path, StickUse use);

}  // namespace openr_host
