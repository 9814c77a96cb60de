#include "openr/controller/step_clock.h"

#include <fmt/format.h>

#include <algorithm>

namespace openr_host {
namespace {

constexpr int64_t kLateWarningPauseNs = 1'000'000'000;

double Milliseconds(int64_t duration_ns) { return static_cast<double>(duration_ns) / 1e6; }

}  // namespace

int64_t StepClock::Next(int64_t now_ns, int64_t step_ns) {
  if (!has_begun_) begin_ns_ = planned_ns_ = now_ns;
  has_begun_ = true;
  step_ns_ = step_ns;
  next_ns_ = planned_ns_ + step_ns;
  return next_ns_;
}

std::string StepClock::Begin(int64_t now_ns) {
  const int64_t took_ns = now_ns - begin_ns_;
  iterations_ += 1;
  asked_ns_ += step_ns_;
  achieved_ns_ += took_ns;
  longest_ns_ = std::max(longest_ns_, took_ns);
  begin_ns_ = now_ns;
  planned_ns_ = next_ns_;
  if (now_ns - next_ns_ <= kLateNs) return "";
  planned_ns_ = now_ns;  // a late iteration does not make the next iterations shorter
  if (warned_ns_ && now_ns - *warned_ns_ < kLateWarningPauseNs) return "";
  warned_ns_ = now_ns;
  return fmt::format("the time step of {:g} ms cannot be held: this iteration took {:.0f} ms",
                     Milliseconds(step_ns_), Milliseconds(took_ns));
}

std::string StepClock::Summary() const {
  if (iterations_ == 0) return "no iteration";
  const auto count = static_cast<double>(iterations_);
  return fmt::format(
      "{} iteration{} in {:.1f} s; asked for were {:g} ms each, achieved {:.1f} ms on average, "
      "{:.0f} ms at most",
      iterations_, iterations_ == 1 ? "" : "s", Milliseconds(achieved_ns_) / 1000,
      Milliseconds(asked_ns_) / count, Milliseconds(achieved_ns_) / count,
      Milliseconds(longest_ns_));
}

}  // namespace openr_host
