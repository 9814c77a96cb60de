// Tells whether a process that is not a child of this one still runs, if it is on the same machine.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// Returns an id that is equal for processes that see the same process ids: it names one boot of one
// kernel and one PID namespace.  A host name does not tell that, containers can share it.  Returns
// "" if the id cannot be read.
std::string MachineId();

// The check of one process.  A default-constructed check reports that the process lives.
class LivenessCheck {
 public:
  LivenessCheck() = default;
  // `machine` is the MachineId() that the process has reported.  For a process of another machine
  // HasEnded() is always false, because its process ids mean nothing here.
  LivenessCheck(const std::string& machine, int64_t pid);

  // Whether the process was killed or has ended.  A new process with the same process id is told
  // apart by its start time.
  bool HasEnded() const;

 private:
  int64_t pid_ = 0;         // 0: unknown
  std::string start_time_;  // in clock ticks since boot; "": hidden from this process
};

}  // namespace openr_host
