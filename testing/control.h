// Refuses threads and real sockets, which a bench cannot control, because their timing differs from
// run to run.
#pragma once

#include <string>
#include <vector>

namespace openr::testing {

// While a ControlledScope exists on this thread, code on this thread cannot make threads or
// sockets.  Each attempt is noted.
class ControlledScope {
 public:
  ControlledScope();
  ~ControlledScope();
  ControlledScope(const ControlledScope&) = delete;
  ControlledScope& operator=(const ControlledScope&) = delete;

  // Returns the attempts in order: "Blinker, in Alarm (message #45), asked for a thread".
  const std::vector<std::string>& refused() const { return refused_; }

  // Notes an attempt and returns true, or returns false when no scope exists.  `what` is "a thread"
  // or "a socket".  Called by the functions that refuse.
  static bool Refuse(const char* what);

 private:
  ControlledScope* const outer_;
  std::vector<std::string> refused_;
};

// Returns the number of threads of this process.
int ThreadCount();

// Notes that a thread was made.  Called by pthread_create().
void NoteThread();

}  // namespace openr::testing
