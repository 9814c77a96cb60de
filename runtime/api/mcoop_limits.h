// Limits of the functions of MCOOP.h, the interface of the robot's operating system, and the
// conversion of its RelativeTime to microseconds.
#pragma once

#include <Time_a.h>

#include <cstddef>
#include <cstdint>

namespace openr_host {

// Largest message in bytes, the size of AperiosMessage.  Longer messages are refused.
constexpr size_t kMessageMax = 256;
constexpr size_t kObjectNameMax = 63;  // longest name of Register(): oobjectNAME_MAX of the SDK
constexpr int kEventsMax = 32;         // pending events of one object; our choice
constexpr int kEntriesMax = 64;        // entries, and so selectors, of one object

inline int64_t Microseconds(const RelativeTime& time) {
  return int64_t{time.sec} * 1'000'000 + int64_t{time.msec} * 1000;
}

}  // namespace openr_host
