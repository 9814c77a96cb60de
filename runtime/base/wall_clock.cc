#include "runtime/base/wall_clock.h"

#include <chrono>

namespace openr_host {

// steady_clock calls clock_gettime(), which runtime/hooks replaces only for code of an image.
int64_t WallClockNs() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace openr_host
