// A robot with stiff joints: the poses of its parts, and how it rests on a flat floor.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "virtualrobot/body/hull.h"
#include "virtualrobot/body/kinematics.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// Computes the poses of the robot's parts from the angles of its joints, and how the robot rests on
// a floor.  Keeps the results for the angles of the last Move().  The next Move() computes again
// only the parts that a joint has moved since then.  All results have the same bits as the results
// of a new StiffRobot with the same angles.
class StiffRobot {
 public:
  // Makes a robot with all joints at 0.  `model` must outlive the robot.
  explicit StiffRobot(const RobotModel& model);
  StiffRobot(const RobotModel& model, const std::vector<double>& angles_rad);

  // Turns joint `joint` to `angle_rad`.  The poses change with the next Move().
  void SetAngle(size_t joint, double angle_rad) { angles_rad_[joint] = angle_rad; }

  // Computes the poses of all parts for the angles that SetAngle() has set.
  void Move();

  // Returns the pose X_BL of each part (see LinkPoses()), as the last Move() has computed it.
  const std::vector<Eigen::Isometry3d>& X_BL() const { return X_BL_; }

  // Returns the centre of mass of all parts, in metres in the base frame B.
  Eigen::Vector3d CentreOfMass() const;

  // Computes how the robot rests on the floor, see PlaceOnFloor() of kinematics.h.  `pose` is
  // changed in place, so that its memory is used again.
  void PlaceOnFloor(RestingPose* pose) const;

  // Returns the height over z = 0 of the robot's lowest point when the trunk is at `X_WB`.  The
  // lowest point belongs to a box (the shape of a part) or to a paw.
  double LowestPoint(const Eigen::Isometry3d& X_WB) const;

 private:
  void PlacePart(size_t i);
  Eigen::Vector3d SupportedPoint() const;

  const RobotModel& model_;
  std::vector<double> angles_rad_;  // angles that SetAngle() has set
  std::vector<double> placed_rad_;  // angles for which X_BL_ and hull_ were computed
  std::vector<Eigen::Isometry3d> X_BL_;
  // For each part: its mass in kg times the position of its centre of mass in metres.  The position
  // is a vector in the coordinate frame B, the base frame of the robot.
  std::vector<Eigen::Vector3d> moments_;
  // For each part, whether Move() has to compute its pose again.  Only Move() uses this vector.  It
  // is a member and no local variable, so that Move() does not allocate memory in each call.
  std::vector<bool> has_moved_;
  double mass_kg_ = 0;
  Hull hull_;
};

}  // namespace openr_host
