#include "runtime/base/wall_clock.h"

#include <chrono>

namespace openr_host {

// Reads the host's clock although runtime/hooks replaces clock_gettime(), which steady_clock calls:
// the replacement acts only while code of an image runs.
int64_t WallClockNs() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace openr_host
