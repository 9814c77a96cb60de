// Durations as people write them: "20s", "250ms", "1.5min".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace openr_host {

// Converts a number with a unit (us, ms, s, min, h) to microseconds.  Returns "", or a description
// of the error; after an error, `duration_us` keeps its value.  Refuses negative numbers, numbers
// without a unit, and more than 1000 h.
std::string ParseDuration(std::string_view text, int64_t* duration_us);

// Returns the duration as a whole number of the largest unit that fits, s, ms or us: 250000 is
// "250ms", and two minutes are "120s".
std::string FormatDuration(int64_t duration_us);

}  // namespace openr_host
