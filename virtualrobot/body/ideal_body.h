// A body without physics: every joint is where its command wants it.
//
// An enabled joint reaches its set point within one frame of 8 ms, but does not pass its mechanical
// stops.  A disabled joint stays where it is.  The robot rests on the flat floor z = 0 as a stiff
// statue would (PlaceOnFloor()).
//
// The body never walks, turns, slides or falls over: x, y and yaw stay as they are at the start.
// The body ignores gains, torques and speed limits, and the drives of its servos are always 0.  It
// does not touch the things of its world, but its distance sensor sees them.  The velocity of its
// base is 0, and its accelerometer measures gravity only.  It cannot be pushed, but a hand can lift
// it.
#pragma once

#include <optional>
#include <vector>

#include "virtualrobot/body/body.h"
#include "virtualrobot/body/stiff_robot.h"

namespace openr_host {

class IdealBody : public Body {
 public:
  // `model` must outlive the body.
  IdealBody(const RobotModel& model, const World& world, const StartPlace& start = {});

  using Body::Advance;
  void SetCommands(const std::vector<JointCommand>& commands) override;
  void Advance() override {}

  // The functions below return the state and the poses at the end of the newest frame.  The
  // functions state(), BodyPoses() and PoseOf() compute the pose of the base only when a joint has
  // moved since the last call, and compute only the parts that have moved.  So a frame whose state
  // is not read takes almost no time.
  const BodyState& state() const override;
  RayHit CastRay(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W,
                 double max_m) const override;
  const World& world() const override { return world_; }
  std::vector<Eigen::Isometry3d> BodyPoses() const override;
  Eigen::Isometry3d PoseOf(size_t part) const override;
  // Moves the base at once to the pose `X_WB`, in which a person's hand holds the robot.  If a part
  // would be below the floor in this pose, the robot is lifted onto the floor.  nullopt: the hand
  // lets go.
  void Hold(const std::optional<Eigen::Isometry3d>& X_WB) override;
  void HashState(Hasher* hasher) const override;

 private:
  void Place() const;
  void PlaceInHand() const;

  const RobotModel& model_;
  const World world_;
  const StartPlace start_;
  std::optional<Eigen::Isometry3d> held_at_;  // the pose that a hand gives to the base
  mutable BodyState state_;
  mutable StiffRobot robot_;  // a stiff robot with the joint angles of the last call of Place()
  mutable RestingPose pose_;  // the pose in which robot_ rests
  // True when the poses of the parts (in robot_), and the base and paws in state_, are computed for
  // the present joint angles.
  mutable bool placed_ = false;
};

}  // namespace openr_host
