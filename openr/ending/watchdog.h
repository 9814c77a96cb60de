// Ends the run when a handler does not return, and names the handler.
#pragma once

#include <cstdint>

namespace openr_host {

// While a Watchdog exists, a handler that uses more than `limit_us` of processor time is reported
// on standard error, and the process ends with status 1.  Only handlers of the thread that made the
// Watchdog are watched.  Time spent stopped in a debugger does not count.  Only one Watchdog may
// exist at a time.  A limit of 0 switches it off.
class Watchdog {
 public:
  explicit Watchdog(int64_t limit_us);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  bool armed_ = false;
};

}  // namespace openr_host
