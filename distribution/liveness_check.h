// Whether a process of this machine that somebody else has started still is.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// Equal for processes to which a process id means the same: of one boot of one kernel and one space
// of process ids.  Names of hosts do not say that; "": not known.
std::string MachineId();

class LivenessCheck {
 public:
  LivenessCheck() = default;
  // `machine`: as the process says; of another one nothing is known here.
  LivenessCheck(const std::string& machine, int64_t pid);

  // Killed or ended; what is a new process of its id is not it.
  bool HasEnded() const;

 private:
  int64_t pid_ = 0;         // 0: not known
  std::string start_time_;  // when, as the kernel counts; "": hidden from this one
};

}  // namespace openr_host
