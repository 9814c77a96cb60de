#include "runtime/base/wall_clock.h"

#include <chrono>

namespace openr_host {

// Reads steady_clock, which calls clock_gettime().  runtime/hooks replaces clock_gettime() by a
// function that gives virtual time to code of an image (a program of the robot).  All other code,
// such as this function, still gets the host's time.
int64_t WallClockNs() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace openr_host
