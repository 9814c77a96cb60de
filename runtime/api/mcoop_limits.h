// Limits of the functions of MCOOP.h, the interface of the robot's operating system, and the
// conversion of its RelativeTime to microseconds.
#pragma once

#include <Time_a.h>

#include <cstddef>
#include <cstdint>

namespace openr_host {

constexpr size_t kObjectNameMax = 63;  // longest name for Register() (oobjectNAME_MAX of the SDK)
constexpr int kEventsMax = 32;         // largest number of pending events of one object; our choice
// Largest number of entries of one object; each entry has a selector.
constexpr int kEntriesMax = 64;

inline int64_t Microseconds(const RelativeTime& time) {
  return int64_t{time.sec} * 1'000'000 + int64_t{time.msec} * 1000;
}

}  // namespace openr_host
