// Where the parts of a robot are for given joint angles, and how it rests on a flat floor.
//
// Everything here is a function of the model and the angles, with the same bits on every
// build (det_math.h; Eigen without vectorization).
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// Rotation by `angle_rad` about the unit vector `axis`.
Eigen::Matrix3d AxisRotation(const Eigen::Vector3d& axis, double angle_rad);

// R_WB from roll (about x), pitch (about y) and yaw (about z), applied in this order:
// Rz(yaw) Ry(pitch) Rx(roll).  Nose down is positive pitch.
Eigen::Matrix3d RotationFromRpy(const Eigen::Vector3d& rpy_rad);

// Roll, pitch, yaw of a rotation; inverse of RotationFromRpy() for |pitch| < pi/2.
Eigen::Vector3d RpyOf(const Eigen::Matrix3d& R);

// X_BL of all bodies, order of RobotModel::bodies: maps a point of the model file (given in
// B at zero angles) to where it is in B at `angles_rad`.  REQUIRES: one angle per joint.
std::vector<Eigen::Isometry3d> LinkPoses(const RobotModel& model,
                                         const std::vector<double>& angles_rad);

// Centre of mass in B of the parts at `X_BL` (as LinkPoses() returns them), in metres.
Eigen::Vector3d CentreOfMass(const RobotModel& model, const std::vector<Eigen::Isometry3d>& X_BL);

// A stiff robot put down on the floor z = 0.
struct RestingPose {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  // x = y = 0, yaw 0
  std::vector<bool> paws;  // order of RobotModel::paws: on the floor
};

// The attitude in which the robot, stiff at `angles_rad`, stands on paws or boxes with its
// centre of mass over the support: the face of its lower hull that lies under the centre.
// Looks for the face near the attitude it would have upright; a robot is not turned over.
RestingPose PlaceOnFloor(const RobotModel& model, const std::vector<double>& angles_rad);
// The same for parts at `X_BL`, as LinkPoses() returns them.
RestingPose PlaceOnFloor(const RobotModel& model, const std::vector<Eigen::Isometry3d>& X_BL);

// Height of the lowest point of any box or paw over z = 0, for a robot at `X_WB`.
double LowestPoint(const RobotModel& model, const std::vector<double>& angles_rad,
                   const Eigen::Isometry3d& X_WB);

}  // namespace openr_host
