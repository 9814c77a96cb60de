// Names the handler that does not return, and ends the run.
#pragma once

#include <cstdint>

namespace openr_host {

// While it lives: a handler of the thread that made it which uses more than `limit_us` of
// processor time is reported on standard error, and the process ends with status 1.  Time
// spent stopped in a debugger does not count.  One at a time; a limit of 0 watches nothing.
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
