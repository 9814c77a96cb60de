// The lock on a file that grows while a run lasts.
#pragma once

#include <sys/stat.h>

#include <string>

namespace openr_host {

// "process 1234 (openr)" of the one that holds the lock (flock) on the file with this status;
// "another process" when the system does not say.
std::string DescribeWriter(const struct stat& file);

}  // namespace openr_host
