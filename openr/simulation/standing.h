// StandingMonitor, which decides whether a robot stands.  The rule is in docs/cli.md.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "virtualrobot/base/det_math.h"
#include "virtualrobot/body/body.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {

class StandingMonitor {
 public:
  static constexpr double kHeightToleranceM = 0.010;
  static constexpr double kAttitudeToleranceRad = Radians(3);
  static constexpr double kSlopeMaxRad = Radians(20);
  static constexpr double kSpeedMaxMs = 0.005;
  static constexpr int64_t kRestingUs = 500'000;

  // Makes a monitor that compares the robot with the posture "stand" of `model`, which must outlive
  // the monitor.  For a model without this posture, standing() always returns false.
  explicit StandingMonitor(const RobotModel& model);

  // Looks at `state`, the state of the body at the virtual time `now_us`, to decide later whether
  // the robot stands.  Must be called once per frame of 8 ms.
  void Sample(const BodyState& state, int64_t now_us);

  // Returns whether the robot stands.  It stands if all paws touch something, its height and
  // attitude over the plane through the paws are near the height and attitude of the model's
  // posture "stand", this plane is no steeper than kSlopeMaxRad, and the trunk has been slower than
  // kSpeedMaxMs for kRestingUs.  Without this last condition, a robot that only passes through this
  // posture while it moves would count as standing.
  bool standing() const;

 private:
  // Pose of a robot relative to the plane that touches its four paws from below.
  struct Stance {
    // Height of the origin of B, the coordinate frame of the robot's base, over the plane below the
    // paws.
    double height_m = 0;
    double roll_rad = 0, pitch_rad = 0;
    // Unit vector at right angles to the plane below the paws, in B, the coordinate frame of the
    // robot's base.
    Eigen::Vector3d up_B{0, 0, 1};
  };

  Stance StanceAt(const std::vector<double>& angles_rad) const;

  const RobotModel* model_;
  std::optional<Stance> posture_;
  // Joint angles and attitude (R_WB_) of the robot when Sample() was last called for a robot that
  // had moved slowly for kRestingUs.  Only standing() compares them with the model's posture
  // "stand".  Sample() only stores them, because computing the poses of all parts costs more time
  // than a frame of a robot without physics.
  std::vector<double> angles_rad_;
  Eigen::Matrix3d R_WB_ = Eigen::Matrix3d::Identity();
  bool all_paws_touch_ = false;
  int64_t last_us_ = -1;
  int64_t resting_us_ = 0;
};

}  // namespace openr_host
