// Durations as people write them: "20s", "250ms", "1.5min".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace openr_host {

// Reads a number with a unit (us, ms, s, min, h) into microseconds.  Returns "" or what is
// wrong; then `duration_us` keeps its value.  Negative, unitless and absurdly long ones (more
// than 1000 h) are refused.
std::string ParseDuration(std::string_view text, int64_t* duration_us);

// The shortest of those forms in seconds or less that says the same: 250000 is "250ms", and two
// minutes are "120s".
std::string FormatDuration(int64_t duration_us);

}  // namespace openr_host
