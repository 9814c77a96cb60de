#include "runtime/base/wall_clock.h"

#include <chrono>

namespace openr_host {

// Reads the host's clock with steady_clock, which calls clock_gettime().  runtime/hooks replaces
// clock_gettime(), but the replacement gives virtual time only to code of an image (a program of
// the robot).
int64_t WallClockNs() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace openr_host
