#include "virtualrobot/base/input_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "runtime/base/duration.h"
#include "runtime/core/robot.h"

namespace openr_host {

std::string ReadNumber(std::string_view text, double* number) {
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, *number);
  const bool is_good = error == std::errc() && at == end && std::isfinite(*number);
  return is_good ? "" : fmt::format("'{}' is no number", text);
}

std::string ReadPercent(std::string_view text, int* percent) {
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, *percent);
  const bool is_good =
      error == std::errc() && end - at == 1 && *at == '%' && *percent >= 0 && *percent <= 100;
  return is_good ? "" : fmt::format("'{}' is no percentage from 0% to 100%", text);
}

std::string TakeForDuration(std::vector<std::string>* words, std::optional<int64_t>* frames) {
  const size_t count = words->size();
  if (count < 2 || (*words)[count - 2] != "for") return "";
  int64_t duration_us = 0;
  if (std::string problem = ParseDuration(words->back(), &duration_us); !problem.empty())
    return problem;
  *frames = std::max<int64_t>((duration_us + kFrameUs - 1) / kFrameUs, 1);
  words->resize(count - 2);
  return "";
}

}  // namespace openr_host
