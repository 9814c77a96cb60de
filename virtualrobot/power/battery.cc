#include "virtualrobot/power/battery.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "runtime/base/assert.h"

namespace openr_host {

int Battery::PercentAt(int64_t time_us) const {
  ASSERT(time_us >= 0, "{} us", time_us);
  if (!drains) return percent;
  // Limits the time before the multiplication, so that the product cannot overflow.
  const int64_t used = std::min(time_us, kEmptyUs) * 100 / kEmptyUs;
  return static_cast<int>(std::max<int64_t>(percent - used, 0));
}

std::string ParseBattery(std::string_view text, Battery* battery) {
  if (text == "drain") {
    *battery = {100, true};
    return "";
  }
  int percent = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, percent);
  const bool is_percent = error == std::errc() && end - at == 1 && *at == '%';
  const bool is_in_range = percent >= 1 && percent <= 100;
  if (!is_percent || !is_in_range) {
    // If the text of the option --battery is a number without a % sign, suggests the number with
    // the sign, because the missing sign is the most common mistake.
    const bool lacks_sign = error == std::errc() && at == end && is_in_range;
    return fmt::format(
        "'{}' is none of 100% (stays full), drain (full at boot) and 1% to 99% (so "
        "much at boot, and drains){}",
        text, lacks_sign ? fmt::format("; did you mean '{}%'?", percent) : "");
  }
  *battery = {percent, percent < 100};
  return "";
}

}  // namespace openr_host
