// What a bench cannot control it refuses: threads and real sockets, whose timing no two
// runs share.
#pragma once

#include <string>
#include <vector>

namespace openr::testing {

// While one lives on this thread: whoever makes a thread or a socket, in this thread, is
// refused it and written down.
class ControlledScope {
 public:
  ControlledScope();
  ~ControlledScope();
  ControlledScope(const ControlledScope&) = delete;
  ControlledScope& operator=(const ControlledScope&) = delete;

  // "Blinker, in Alarm (message #45), asked for a thread", in order.
  const std::vector<std::string>& refused() const { return refused_; }

  // For the functions that refuse.  `what`: "a thread".  False when nothing is controlled.
  static bool Refuse(const char* what);

 private:
  ControlledScope* const outer_;
  std::vector<std::string> refused_;
};

// Threads of this process.
int ThreadCount();

// For pthread_create().
void NoteThread();

}  // namespace openr::testing
