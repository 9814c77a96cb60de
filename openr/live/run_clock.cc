#include "openr/live/run_clock.h"

#include <algorithm>

namespace openr_host {

void RunClock::Pause() {
  paused_ = true;
  goal_us_ = INT64_MAX;
}

void RunClock::GoOn() {
  paused_ = false;
  steps_left_ = 0;
  goal_us_ = INT64_MAX;
}

void RunClock::GoTo(int64_t time_us) {
  GoOn();
  goal_us_ = time_us;
}

void RunClock::AddSteps(Step step, int count) {
  Pause();
  // Drops the steps that are left if they are of another kind than `step`, because steps_left_ can
  // count only steps of one kind.
  if (step != step_) steps_left_ = 0;
  step_ = step;
  steps_left_ = std::clamp(steps_left_ + count, 0, kStepsMax);
}

RunClock::Step RunClock::TakeStep() {
  if (steps_left_ == 0) return Step::kNone;
  --steps_left_;
  return step_;
}

bool RunClock::ParseStep(std::string_view name, Step* step) {
  *step = name == "frame"     ? Step::kFrame
          : name == "message" ? Step::kMessage
          : name == "vector"  ? Step::kVector
                              : Step::kNone;
  return *step != Step::kNone;
}

}  // namespace openr_host
