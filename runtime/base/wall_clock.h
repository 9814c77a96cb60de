// The clock of the host, for pacing, time limits of processes and measurements.  Nothing that a
// program can see may depend on it.
#pragma once

#include <cstdint>

namespace openr_host {

// Returns the time of the monotonic clock in nanoseconds; its origin is arbitrary.  Code of an
// image would get the robot's clock; see ApiScope.
int64_t WallClockNs();

inline int64_t WallClockMs() { return WallClockNs() / 1'000'000; }

}  // namespace openr_host
