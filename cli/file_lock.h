// Finds the process that is writing to a file.  This is possible because a run holds a lock on each
// file that it keeps open for writing, such as a recording.
#pragma once

#include <sys/stat.h>

#include <string>

namespace openr_host {

// Returns "process 1234 (openr)" for the process that holds a lock (flock) on a file.  Returns
// "another process" when the system does not say which process holds the lock.  `file` is the
// file's status as stat() gives it.
std::string DescribeWriter(const struct stat& file);

// Returns the error message about `file`, which another process has locked: "FILE: is being written
// by process 1234 (openr); ...".  `status` is the file's status.
std::string IsBeingWritten(const std::string& file, const struct stat& status);

}  // namespace openr_host
