// The wall clock of the host, for pacing, time limits of processes and measurements.  Nothing that
// a program of the robot can see may depend on this clock.
#pragma once

#include <cstdint>

namespace openr_host {

// Returns the time of the host's monotonic clock in nanoseconds; its origin is arbitrary.  While
// code of an image (a program of the robot) runs, this function would return the robot's virtual
// time.  So a function of the runtime that an image calls must first make an ApiScope (current.h),
// which marks code of the runtime.
int64_t WallClockNs();

inline int64_t WallClockMs() { return WallClockNs() / 1'000'000; }

}  // namespace openr_host
