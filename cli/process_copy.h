// Copies of this process, made with fork(), that answer through a pipe.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <functional>
#include <string>

namespace openr_host {

struct ProcessCopy {
  pid_t pid = -1;
  int answers = -1;  // the end of the pipe to read from; the caller closes it
};

// Forks.  The copy calls `work` with the end of the pipe to write to, and then ends with status 0.
// What the standard streams have buffered is written first, so that it is not written twice.
// Throws std::runtime_error when there is no pipe or no further process.
// REQUIRES: the process has one thread.
ProcessCopy StartCopy(const std::function<void(int answers)>& work);

// Returns what comes from `descriptor` until its end or an error; also writes it to `echo` as it
// comes, if that is not null.
std::string ReadToEnd(int descriptor, std::FILE* echo = nullptr);

// Waits for the end of the child process `child` and returns its status as waitpid() gives it.
// REQUIRES: nothing else has waited for the end of `child`.
int WaitForEnd(pid_t child);

}  // namespace openr_host
