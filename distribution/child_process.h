// A process of this host that belongs to the run: started, watched, ended with it.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace openr_host {

class ChildProcess {
 public:
  // Starts `command`, whose first word is looked for in PATH; what it prints goes to standard
  // error.  `is_interactive`: it shares the terminal, as a debugger does.  Throws
  // std::runtime_error.
  ChildProcess(std::string name, const std::vector<std::string>& command, bool is_interactive);
  ~ChildProcess();  // kills it if it has not ended
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t pid() const { return pid_; }

  // "process 'vision' (pid 123) was killed by signal 9 (Killed)", or "" while it runs.
  std::string HowItEnded();

  // Waits for its end; kills it when that takes longer.
  void WaitForEnd(int64_t limit_ms);

 private:
  bool UpdateStatus(bool waits);

  const std::string name_;
  pid_t pid_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

}  // namespace openr_host
