// LagMeter: measures the time by which the joints of a robot lag behind the joints of the robot
// that it follows.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace openr_host {

// Measures the lag, the time by which the follower moves later than the leader, by correlation of
// measured positions: shifts the positions of the follower in time until they fit the positions of
// the leader best.  The round trip of a packet cannot be used instead: it is only a part of the
// lag, because the joints need time, too.
class LagMeter {
 public:
  // Duration of the movement that is compared between the two robots.
  static constexpr int64_t kWindowMs = 3000;
  // The largest lag of the follower behind the leader that LagMs() can find.
  static constexpr int64_t kLagMaxMs = 1500;
  // The smallest range of movement, in 0.01 degree, of a joint that is used to measure the lag, the
  // time by which the follower moves later than the leader.
  static constexpr int32_t kRangeMin = 300;

  // Adds the positions of all joints at `time_ms`, in 0.01 degree: AddLeader() those of the leader,
  // AddFollower() those of the follower.  If `time_ms` is before the time of the last added
  // positions of the same robot, uses that time instead.
  void AddLeader(int64_t time_ms, const std::vector<int32_t>& joints);
  void AddFollower(int64_t time_ms, const std::vector<int32_t>& joints);

  // Returns the lag in ms, the time by which the follower moves later than the leader; nullopt if
  // no joint has moved enough, or if the movements of the two robots are too different.
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
  double RelativeError(int joint, int64_t lag_ms, int64_t from_ms) const;

  Series leader_, follower_;
};

}  // namespace openr_host
