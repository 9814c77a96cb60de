// Durations as people write them: "20s", "250ms", "1.5min".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace openr_host {

// Reads a number with a unit (us, ms, s, min, h) into microseconds.  Returns "" or a description of
// the error; then `duration_us` keeps its value.  Refuses negative numbers, numbers without a unit,
// and more than 1000 h.
std::string ParseDuration(std::string_view text, int64_t* duration_us);

// Returns the shortest text in s, ms or us for the duration: 250000 is "250ms", and two minutes are
// "120s".
std::string FormatDuration(int64_t duration_us);

}  // namespace openr_host
