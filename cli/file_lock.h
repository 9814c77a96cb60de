// The lock on a file that grows while a run writes it.
#pragma once

#include <sys/stat.h>

#include <string>

namespace openr_host {

// Returns "process 1234 (openr)" for the process that holds the lock (flock) on the file with the
// status `file`; "another process" when the system does not say which.
std::string DescribeWriter(const struct stat& file);

}  // namespace openr_host
