// Starts copies of this process with fork().  They send their answers through a pipe.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <functional>
#include <string>

namespace openr_host {

struct ProcessCopy {
  pid_t pid = -1;
  int answers = -1;  // reading end of the pipe; the caller closes it
};

// Makes a copy of this process with fork().  The copy calls `work` with the writing end of the
// pipe, and then ends with status 0.  Text in the buffers of the standard streams is written
// before, so that the copy does not write it a second time.  Throws std::runtime_error when the
// system gives no pipe or no process.
// REQUIRES: the process has one thread.
ProcessCopy StartCopy(const std::function<void(int answers)>& work);

// Returns the text that is read from `descriptor` until its end or an error.  If `echo` is not
// null, also writes the text to it as soon as it comes.  Calls `while_waiting`, if it is not null,
// about every 200 ms.
std::string ReadToEnd(int descriptor, std::FILE* echo = nullptr,
                      const std::function<void()>& while_waiting = {});

// Waits for the end of the child process `child` and returns its status as waitpid() gives it.
// REQUIRES: nothing else has waited for the end of `child`.
int WaitForEnd(pid_t child);

}  // namespace openr_host
