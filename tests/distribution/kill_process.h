// Sends signals to a single process.
#pragma once

#include <signal.h>
#include <sys/types.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace openr_host {

// Sends `signal` to the process `pid`.
//
// A search for a process that finds none returns -1 or 0.  For kill() these mean every process of
// the machine or of the group, so they throw, as does a process that is gone.  An exception ends
// the test also from a helper function, where an ASSERT would only leave the helper.
inline void KillProcess(int64_t pid, int signal) {
  if (pid <= 1) throw std::runtime_error("no signal to process " + std::to_string(pid));
  if (kill(static_cast<pid_t>(pid), signal) == 0) return;
  throw std::runtime_error("process " + std::to_string(pid) + ": " + std::strerror(errno));
}

}  // namespace openr_host
