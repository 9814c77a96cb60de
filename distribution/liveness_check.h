// Tests whether a process of this machine still runs.  Unlike waitpid(), the test also works for
// processes that are not children of this process.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// Returns an id that is equal for all processes that see the same process ids.  The id names one
// boot of one kernel and one PID namespace.  A host name is not enough, because two containers can
// have the same host name.  Returns "" if the id cannot be read.
std::string MachineId();

// Tests whether one process still exists.  A LivenessCheck that was made without arguments has no
// process to test, and always reports that the process exists.
class LivenessCheck {
 public:
  LivenessCheck() = default;
  // `machine` is the MachineId() that the process has reported.  For a process of another machine
  // HasEnded() is always false, because the process ids of that machine mean nothing on this
  // machine.
  LivenessCheck(const std::string& machine, int64_t pid);

  // Returns whether the process was killed or has ended.  A new process that has got the same id is
  // recognised by its start time, and does not count as the tested process.
  bool HasEnded() const;

 private:
  int64_t pid_ = 0;  // id of the tested process; 0 if there is no process to test
  // Start time of the process pid_ in clock ticks since the boot of this machine; "" if our process
  // may not read the start time.
  std::string start_time_;
};

}  // namespace openr_host
