// Ends the run when a handler does not return, and names the handler.
#pragma once

#include <cstdint>

namespace openr_host {

// While it exists: if a handler of the thread that made it uses more than `limit_us` of processor
// time, that is reported on standard error and the process ends with status 1.  Time spent stopped
// in a debugger does not count.  Only one may exist at a time.  A limit of 0 switches it off.
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
