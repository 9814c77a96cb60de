// Ends the run when a handler or a constructor of an object does not return, and names it.
#pragma once

#include <cstdint>

namespace openr_host {

// While a Watchdog exists, a handler that uses more than `limit_us` of processor time is reported
// on standard error, and the process ends with status 1.  The same holds for the loading of an
// image, which runs the constructors of the image's globals.  Only handlers on the thread that made
// the Watchdog are watched.  The time during which a debugger stops the process does not count.  A
// Watchdog with a limit of 0 does nothing.  Only one Watchdog may exist at a time.  EndGuards
// (end_guards.h) makes it, and describes `limit_us` and `flag`.
class Watchdog {
 public:
  Watchdog(int64_t limit_us, const char* flag);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  // Starts the timer of the handlers' time limit again in a fork of the process, because a fork has
  // no timers.
  void StartAgain();

 private:
  bool StartTimer() const;

  const int64_t limit_us_;
  bool armed_ = false;
};

}  // namespace openr_host
