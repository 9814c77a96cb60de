// The clock of the host, for pacing, time limits of processes and measurements.  Nothing that an
// object can see may depend on this clock.
#pragma once

#include <cstdint>

namespace openr_host {

// Returns the time of the monotonic clock in nanoseconds; its origin is arbitrary.  While code of
// an image runs, the call would return the robot's clock, so callers there need an ApiScope.
int64_t WallClockNs();

inline int64_t WallClockMs() { return WallClockNs() / 1'000'000; }

}  // namespace openr_host
