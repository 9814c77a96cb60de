#include "runtime/base/wall_clock.h"

#include <chrono>

namespace openr_host {

// Reads steady_clock, which calls clock_gettime().  For code of an image (a program of the robot),
// runtime/hooks makes clock_gettime() return virtual time.  For all other code, such as this
// function, clock_gettime() returns the host's time.
int64_t WallClockNs() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace openr_host
