// StepClock, which paces the iterations of a controller in real time.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace openr_host {

// Computes when the next iteration of the controller's loop is to begin, and measures the duration
// of iterations.  The caller passes in the present time.
class StepClock {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Duration = std::chrono::steady_clock::duration;

  // The largest delay with which an iteration still counts as on time: a frame of the robot.
  static constexpr std::chrono::milliseconds kLate{8};

  // Returns the time at which the next iteration is to begin: `step` after the planned beginning of
  // the present iteration.  Called at the end of an iteration.  The first call takes `now` for the
  // time at which the first iteration has begun.
  Time Next(Time now, Duration step);

  // Begins the next iteration at the time `now`.  Returns a warning if `now` is more than kLate
  // after the time that Next() has returned; else "".  Warns at most once a second.  A late
  // iteration does not make the next iterations shorter, because they are planned from `now` on.
  std::string Begin(Time now);

  int64_t iterations() const { return iterations_; }  // number of iterations that have ended

  // Returns a text about the time steps that were asked for and achieved: "640 iterations in 41.0
  // s; asked for were 64 ms each, achieved 64.1 ms on average, 71 ms at most".
  std::string Summary() const;

 private:
  bool has_begun_ = false;
  Time begin_{};    // time at which the present iteration of the loop has begun
  Time planned_{};  // time at which the present iteration of the loop was to begin
  Time next_{};
  Time warned_{};
  Duration step_{};
  Duration asked_{}, achieved_{}, longest_{};
  int64_t iterations_ = 0;
};

}  // namespace openr_host
