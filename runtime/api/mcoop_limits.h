// Limits, and the conversion of a RelativeTime to microseconds, for the functions of MCOOP.h.
// MCOOP.h is the interface of the robot's operating system.
#pragma once

#include <Time_a.h>

#include <cstddef>
#include <cstdint>

namespace openr_host {

constexpr size_t kMessageMax = 256;    // size of AperiosMessage; longer messages are refused
constexpr size_t kObjectNameMax = 63;  // value of oobjectNAME_MAX in the SDK
constexpr int kEventsMax = 32;         // pending events of one object; our choice
constexpr int kEntriesMax = 64;        // number of selectors of an object

inline int64_t Microseconds(const RelativeTime& time) {
  return int64_t{time.sec} * 1'000'000 + int64_t{time.msec} * 1000;
}

}  // namespace openr_host
