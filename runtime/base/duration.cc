#include "runtime/base/duration.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

namespace openr_host {
namespace {

struct Unit {
  std::string_view name;
  int64_t us;
};
constexpr Unit kUnits[] = {
    {"h", 3'600'000'000}, {"min", 60'000'000}, {"s", 1'000'000}, {"ms", 1000}, {"us", 1}};
constexpr int64_t kLongestUs = 1000 * kUnits[0].us;

}  // namespace

std::string ParseDuration(std::string_view text, int64_t* duration_us) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
  if (error != std::errc() || !std::isfinite(number)) {
    return fmt::format("'{}' is no duration; write 20s, 250ms or 2min", text);
  }
  const std::string_view name(stop, static_cast<size_t>(end - stop));
  if (name.empty()) {
    return fmt::format("'{0}' has no unit; write {0}s or {0}ms", text);
  }
  for (const Unit& unit : kUnits) {
    if (name != unit.name) continue;
    const double us = number * static_cast<double>(unit.us);
    if (us < 0 || us > static_cast<double>(kLongestUs)) {
      return fmt::format("'{}' is out of range; durations go from 0 to 1000h", text);
    }
    *duration_us = std::llround(us);
    return "";
  }
  return fmt::format("'{}' has the unknown unit '{}'; units are us, ms, s, min, h", text, name);
}

std::string FormatDuration(int64_t duration_us) {
  for (const Unit& unit : kUnits) {
    if (unit.us > 1'000'000) continue;
    if (duration_us != 0 && duration_us % unit.us == 0) {
      return fmt::format("{}{}", duration_us / unit.us, unit.name);
    }
  }
  return "0s";
}

}  // namespace openr_host
