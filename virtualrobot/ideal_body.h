// A body without physics: joints are where they are told to be.
//
// An enabled joint reaches its set point within the frame, kept to its mechanical stops; a
// disabled one stays where it is.  The robot rests on the flat floor z = 0 on whatever part
// is lowest under its centre of mass, as a stiff statue would (PlaceOnFloor()).
//
// What it does not do: it never walks, turns, slides or falls over (x, y and yaw stay 0);
// it ignores gains, drives (always 0), torques, time and speed limits; it does not feel
// the boxes of its world, which only its distance sensor sees; its base velocity is 0 and
// its acceleration is gravity alone.
#pragma once

#include "virtualrobot/body.h"
#include "virtualrobot/kinematics.h"

namespace openr_host {

class IdealBody : public Body {
 public:
  // `model` must outlive the body.
  IdealBody(const RobotModel& model, const World& world);

  void Advance(const std::vector<JointCommand>& commands) override;

  // The base is placed when somebody asks and a joint has moved since; frames nobody looks
  // at cost next to nothing.
  const BodyState& state() const override;
  double RayDistance(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W,
                     double max_m) const override;
  std::vector<Eigen::Isometry3d> BodyPoses() const override;
  void HashState(Hasher* hasher) const override;

 private:
  std::vector<double> Angles() const;
  void Place() const;

  const RobotModel& model_;
  const World world_;
  mutable BodyState state_;
  mutable std::vector<Eigen::Isometry3d> X_WL_;  // as BodyPoses() says
  mutable bool placed_ = false;  // state_'s base and paws, and X_WL_, belong to its joint angles
};

}  // namespace openr_host
