// Limits of the Aperios calls, and what they share.
#pragma once

#include <Time_a.h>

#include <cstddef>
#include <cstdint>

namespace openr_host {

constexpr size_t kMessageMax = 256;    // AperiosMessage: a longer one is refused
constexpr size_t kObjectNameMax = 63;  // oobjectNAME_MAX
constexpr int kEventsMax = 32;         // timed messages of one object; chosen
constexpr int kEntriesMax = 64;        // selectors of an object

inline int64_t Microseconds(const RelativeTime& time) {
  return int64_t{time.sec} * 1'000'000 + int64_t{time.msec} * 1000;
}

}  // namespace openr_host
