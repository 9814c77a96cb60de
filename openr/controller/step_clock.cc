#include "openr/controller/step_clock.h"

#include <fmt/format.h>

#include <algorithm>

namespace openr_host {
namespace {

double Milliseconds(StepClock::Duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

}  // namespace

StepClock::Time StepClock::Next(Time now, Duration step) {
  if (!has_begun_) begin_ = planned_ = now;
  has_begun_ = true;
  step_ = step;
  next_ = planned_ + step;
  return next_;
}

std::string StepClock::Begin(Time now) {
  const Duration took = now - begin_;
  iterations_ += 1;
  asked_ += step_;
  achieved_ += took;
  longest_ = std::max(longest_, took);
  begin_ = now;
  planned_ = next_;
  if (now - next_ <= kLate) return "";
  planned_ = now;  // a late iteration does not make the next iterations shorter
  if (warned_ != Time{} && now - warned_ < std::chrono::seconds(1)) return "";
  warned_ = now;
  return fmt::format("the time step of {:g} ms cannot be held: this iteration took {:.0f} ms",
                     Milliseconds(step_), Milliseconds(took));
}

std::string StepClock::Summary() const {
  if (iterations_ == 0) return "no iteration";
  const auto count = static_cast<double>(iterations_);
  return fmt::format(
      "{} iteration{} in {:.1f} s; asked for were {:g} ms each, achieved {:.1f} ms on average, "
      "{:.0f} ms at most",
      iterations_, iterations_ == 1 ? "" : "s", Milliseconds(achieved_) / 1000,
      Milliseconds(asked_) / count, Milliseconds(achieved_) / count, Milliseconds(longest_));
}

}  // namespace openr_host
