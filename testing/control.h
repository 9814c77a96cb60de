// Refuses what a bench cannot control: threads and real sockets.  Their timing differs from run to
// run.
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

  // Called by the functions that refuse.  `what` is "a thread" or the like.  Returns false when no
  // scope exists.
  static bool Refuse(const char* what);

 private:
  ControlledScope* const outer_;
  std::vector<std::string> refused_;
};

// Returns the number of threads of this process.
int ThreadCount();

// Called by pthread_create().
void NoteThread();

}  // namespace openr::testing
