// StepClock, which paces the iterations of a controller in real time.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace openr_host {

// Says when the next iteration is to begin, and counts how long iterations were.  Times come from
// the caller.
class StepClock {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Duration = std::chrono::steady_clock::duration;

  // How late an iteration may begin without being taken for late: a frame of the robot.
  static constexpr std::chrono::milliseconds kLate{8};

  // Called at the end of an iteration, which asks for `step`.  Returns when the next one begins:
  // `step` after this one began.  The first call counts `now` as the begin of the first iteration.
  Time Next(Time now, Duration step);

  // Called when the next iteration begins.  Returns "" if it begins at most kLate after the time
  // that Next() returned.  Otherwise plans the further iterations from now, because lost time is
  // not made up for, and returns a warning, at most one a second.
  std::string Begin(Time now);

  int64_t iterations() const { return iterations_; }  // whole ones: their successor has begun

  // Describes asked and achieved time steps: "640 iterations in 41.0 s; asked for were 64 ms each,
  // achieved 64.1 ms on average, 71 ms at most".
  std::string Summary() const;

 private:
  bool has_begun_ = false;
  Time begin_{};    // of the present iteration, as it was
  Time planned_{};  // of the present iteration, as it should have been
  Time next_{};
  Time warned_{};
  Duration step_{};
  Duration asked_{}, achieved_{}, longest_{};
  int64_t iterations_ = 0;
};

}  // namespace openr_host
