// StandingMonitor, which decides whether a robot stands, by the rule of docs/cli.md.
#pragma once

#include <cstdint>

#include "virtualrobot/body.h"
#include "virtualrobot/det_math.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {

class StandingMonitor {
 public:
  static constexpr double kHeightToleranceM = 0.010;
  static constexpr double kAttitudeToleranceRad = Radians(3);
  static constexpr double kSpeedMaxMs = 0.005;
  static constexpr int64_t kCalmUs = 500'000;

  // The posture to compare with is "stand" of `model` on a flat floor.  For a model without this
  // posture, standing() always returns false.
  explicit StandingMonitor(const RobotModel& model);

  // Compares `state`, the body's state at virtual time `now_us`, with the posture.  Called once per
  // frame of 8 ms.
  void Sample(const BodyState& state, int64_t now_us);

  // Returns whether the robot stands: all paws touch the floor, height and attitude are near those
  // of the posture, and the trunk has been slower than kSpeedMaxMs for kCalmUs.  Without this last
  // condition, a robot that only passes through the posture while it moves would count as standing.
  bool standing() const { return upright_ && calm_us_ >= kCalmUs; }

 private:
  bool IsUpright(const BodyState& state) const;

  bool has_posture_ = false;
  double height_m_ = 0;
  double roll_rad_ = 0, pitch_rad_ = 0;
  bool upright_ = false;
  int64_t last_us_ = -1;
  int64_t calm_us_ = 0;
};

}  // namespace openr_host
