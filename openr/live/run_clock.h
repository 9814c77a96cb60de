// RunClock: keeps the rate of a run, its pause, and the steps that a paused run has still to make.
//
// The clock decides only when a run goes on, never what happens in it.  So changes of the clock are
// not part of a recording.
#pragma once

#include <cstdint>
#include <string_view>

namespace openr_host {

class RunClock {
 public:
  // A kind of step of a paused run.  The run goes on to the end of the frame of 8 ms, or until the
  // next message is delivered, or until the next message with sensor values is delivered.
  enum class Step { kNone, kFrame, kMessage, kVector };

  // The largest number of steps that a paused run may still have to make.
  static constexpr int kStepsMax = 1000;

  // Makes a clock with the rate `rate`: virtual seconds per second of the computer's clock; 0: as
  // fast as possible.  If `is_fixed`, the run cannot be paused and keeps its rate, because its
  // handlers run in free-running workers, which do not wait for it.
  explicit RunClock(double rate, bool is_fixed = false) : rate_(rate), is_fixed_(is_fixed) {}

  bool is_fixed() const { return is_fixed_; }

  double rate() const { return rate_; }
  void set_rate(double rate) { rate_ = rate; }

  bool paused() const { return paused_; }
  void Pause();
  void GoOn();

  // Pauses the run, and makes it go on for `count` steps of the kind `step`.  If steps of another
  // kind wait, replaces them.
  void AddSteps(Step step, int count);
  // Removes one of the steps that the run has still to make, and returns the kind of this step;
  // kNone if no step is left.
  Step TakeStep();

  // Makes the run go on as fast as possible to the virtual time `time_us`, and pauses the run at
  // this time.
  void GoTo(int64_t time_us);
  // Returns the virtual time at which GoTo() will pause the run; INT64_MAX: no such time is
  // set.
  int64_t goal_us() const { return goal_us_; }

  // Sets `step` to the step that `name` means: "frame", "message" or "vector".  Returns false for
  // other names.
  static bool ParseStep(std::string_view name, Step* step);

 private:
  double rate_;
  const bool is_fixed_;
  bool paused_ = false;
  Step step_ = Step::kNone;
  int steps_left_ = 0;
  int64_t goal_us_ = INT64_MAX;
};

}  // namespace openr_host
