#include "bench/limit.h"

#include <fmt/format.h>

namespace openr_host {

bool IsMet(const Limit& limit, const Figures& figures) {
  switch (limit.kind) {
    case Limit::Kind::kRatioAtMost:
      return figures.ratio <= limit.value;
    case Limit::Kind::kRatioAtLeast:
      return figures.ratio >= limit.value;
    case Limit::Kind::kMoreThanFloor:
      return figures.more_ns <= limit.value;
    case Limit::Kind::kTime:
      return figures.time_ns <= limit.value;
  }
  return false;
}

const char* NameOf(Limit::Kind kind) {
  switch (kind) {
    case Limit::Kind::kRatioAtMost:
      return "ratio_at_most";
    case Limit::Kind::kRatioAtLeast:
      return "ratio_at_least";
    case Limit::Kind::kMoreThanFloor:
      return "more_ns_at_most";
    case Limit::Kind::kTime:
      return "time_ns_at_most";
  }
  return "";
}

std::string TextOf(const Limit& limit) {
  switch (limit.kind) {
    case Limit::Kind::kRatioAtMost:
      return fmt::format("<= {:.2f}x", limit.value);
    case Limit::Kind::kRatioAtLeast:
      return fmt::format(">= {:.2f}x", limit.value);
    case Limit::Kind::kMoreThanFloor:
      return fmt::format("<= +{}", TextOfTime(limit.value));
    case Limit::Kind::kTime:
      return fmt::format("<= {}", TextOfTime(limit.value));
  }
  return "";
}

std::string TextOfTime(double ns) {
  if (ns < 1e3) return fmt::format("{:.1f} ns", ns);
  if (ns < 1e6) return fmt::format("{:.2f} us", ns / 1e3);
  if (ns < 1e9) return fmt::format("{:.2f} ms", ns / 1e6);
  return fmt::format("{:.2f} s", ns / 1e9);
}

}  // namespace openr_host
