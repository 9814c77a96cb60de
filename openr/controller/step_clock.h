// StepClock, which paces the iterations of a controller in real time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace openr_host {

// Computes when the next iteration of the controller's loop is to begin, and measures the duration
// of iterations.  The caller passes in the present time by the wall clock (wall_clock.h).
class StepClock {
 public:
  // The largest delay with which an iteration still counts as on time: a frame of the robot.
  static constexpr int64_t kLateNs = 8'000'000;

  // Returns the time at which the next iteration is to begin: `step_ns` after the planned beginning
  // of the present iteration.  Called at the end of an iteration.  The first call takes `now_ns`
  // for the time at which the first iteration has begun.
  int64_t Next(int64_t now_ns, int64_t step_ns);

  // Begins the next iteration at the time `now_ns`.  Returns a warning if `now_ns` is more than
  // kLateNs after the time that Next() has returned; else "".  Warns at most once a second.  A late
  // iteration does not make the next iterations shorter, because they are planned from `now_ns` on.
  std::string Begin(int64_t now_ns);

  int64_t iterations() const { return iterations_; }  // number of iterations that have ended

  // Returns a text about the time steps that were asked for and achieved: "640 iterations in 41.0
  // s; asked for were 64 ms each, achieved 64.1 ms on average, 71 ms at most".
  std::string Summary() const;

 private:
  bool has_begun_ = false;
  int64_t begin_ns_ = 0;    // time at which the present iteration of the loop has begun
  int64_t planned_ns_ = 0;  // time at which the present iteration of the loop was to begin
  int64_t next_ns_ = 0;
  std::optional<int64_t> warned_ns_;  // time of the last warning
  int64_t step_ns_ = 0;
  int64_t asked_ns_ = 0, achieved_ns_ = 0, longest_ns_ = 0;
  int64_t iterations_ = 0;
};

}  // namespace openr_host
