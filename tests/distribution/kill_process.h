// Signals to one process.
#pragma once

#include <signal.h>
#include <sys/types.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace openr_host {

// Sends `signal` to the process `pid`.  What helpers return for one that they have not found, -1 or
// 0, would be every process of this machine, or of this group: those, and a process that is gone,
// end the test by an exception, which a helper in between cannot swallow as it does an ASSERT.
inline void KillProcess(int64_t pid, int signal) {
  if (pid <= 1) throw std::runtime_error("no signal to process " + std::to_string(pid));
  if (kill(static_cast<pid_t>(pid), signal) == 0) return;
  throw std::runtime_error("process " + std::to_string(pid) + ": " + std::strerror(errno));
}

}  // namespace openr_host
