// LagMeter: how long one robot's joints are behind those of another one that they follow.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace openr_host {

// Measures the lag by correlation of measured positions: it shifts the positions of the follower in
// time until they fit those of the leader best.  The round trip of a packet would be only a part of
// the lag, because the joints need time, too.
class LagMeter {
 public:
  // The movement that is looked at, and the largest lag that is found.
  static constexpr int64_t kWindowMs = 3000;
  static constexpr int64_t kLagMaxMs = 1500;
  // Range in which a joint of the leader must have moved, in 0.01 degree, to say something.
  static constexpr int32_t kRangeMin = 300;

  // Adds positions of all joints, in 0.01 degree, that the robot had at `time_ms`.  A time before
  // that of the last positions counts as that.
  void AddLeader(int64_t time_ms, const std::vector<int32_t>& joints);
  void AddFollower(int64_t time_ms, const std::vector<int32_t>& joints);

  // Returns the lag in ms; none if no joint has moved enough, or the movements do not fit.
  std::optional<int64_t> LagMs() const;

  void Clear();

 private:
  struct Sample {
    int64_t time_ms;
    std::vector<int32_t> joints;
  };
  using Series = std::deque<Sample>;

  static void Add(Series* series, int64_t time_ms, const std::vector<int32_t>& joints);
  int LiveliestJoint(int64_t from_ms) const;
  double Misfit(int joint, int64_t lag_ms, int64_t from_ms) const;

  Series leader_, follower_;
};

}  // namespace openr_host
