// ChildProcess: a process on this host, such as a worker, that this process starts, watches and
// ends.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace openr_host {

class ChildProcess {
 public:
  // Starts `command`; its first word is searched for in PATH.  Standard output of the new process
  // goes to standard error of this process.  If `is_interactive` is true, the new process, such as
  // a debugger, stays in the process group of this process, so that it can use the terminal.
  // Throws std::runtime_error if the process cannot be started.
  ChildProcess(std::string name, const std::vector<std::string>& command, bool is_interactive);
  ~ChildProcess();  // kills the process if it still runs
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t pid() const { return pid_; }

  // Describes how the process has ended, such as "process 'vision' (pid 123) was killed by signal 9
  // (Killed)"; "" while the process runs.
  std::string EndText();

  // Waits for the end of the process, at most `limit_ms`.  Returns whether the process has ended.
  bool WaitForEnd(int64_t limit_ms);

  // Kills the process if it still runs, and waits for its end.
  void Kill();

 private:
  // Asks the kernel whether the process has ended, and returns the answer.  If `waits` is true,
  // first waits for the end.
  bool UpdateStatus(bool waits);

  const std::string name_;
  pid_t pid_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

}  // namespace openr_host
