// Refuses new threads and real sockets to objects on a bench, because their timing differs from run
// to run, so the bench could not repeat a run.
#pragma once

#include <string>
#include <vector>

namespace openr::testing {

// While a ControlledScope exists on a thread, code on this thread cannot create threads or sockets.
// A bench has a scope while it lets the robot run.
class ControlledScope {
 public:
  ControlledScope();
  ~ControlledScope();
  ControlledScope(const ControlledScope&) = delete;
  ControlledScope& operator=(const ControlledScope&) = delete;

  // Returns a text for each call of a function of the host that this scope has refused, in the
  // order of the calls: "Blinker, in Alarm (message #45), asked for a thread".
  const std::vector<std::string>& refused() const { return refused_; }

  // Returns whether a ControlledScope exists on the calling thread.  If so, adds to refused() that
  // the running object asked for `what`: "a thread" or "a socket of the host".  Our
  // pthread_create() and socket() call this function, and fail if the result is true.
  static bool Refuse(const char* what);

 private:
  ControlledScope* const outer_;
  std::vector<std::string> refused_;
};

// Returns the number of threads of this process.
int ThreadCount();

// Notes that the process has created a thread.  Until then ThreadCount() returns 1 without
// counting.  Called by our pthread_create().
void NoteThread();

}  // namespace openr::testing
