// Poses of a robot's parts for given joint angles, and the pose in which it rests on a flat floor.
//
// All results depend on the model and the angles only and have the same bits in every build
// (det_math.h; Eigen without vectorization).
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

// Pose X_BL of each body, order of RobotModel::bodies.  Maps a point of the body, given as in the
// model file (in B at zero angles), to its place in B at `angles_rad`.  REQUIRES: one angle per
// joint.
std::vector<Eigen::Isometry3d> LinkPoses(const RobotModel& model,
                                         const std::vector<double>& angles_rad);

// Centre of mass in B of the parts at `X_BL` (as LinkPoses() returns them), in metres.
Eigen::Vector3d CentreOfMass(const RobotModel& model, const std::vector<Eigen::Isometry3d>& X_BL);

// The pose of a stiff robot that rests on the floor z = 0.
struct RestingPose {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  // x = y = 0, yaw 0
  std::vector<bool> paws;  // whether each paw is on the floor; order of RobotModel::paws
};

// Computes how a robot that is stiff at `angles_rad` rests on the floor: on the face of its lower
// hull that lies under its centre of mass.  The hull is that of paws and boxes.  The search begins
// with an upright robot, so the robot never comes to rest on its back.
RestingPose PlaceOnFloor(const RobotModel& model, const std::vector<double>& angles_rad);
// Does the same for parts at `X_BL`, as LinkPoses() returns them.
RestingPose PlaceOnFloor(const RobotModel& model, const std::vector<Eigen::Isometry3d>& X_BL);

// Height of the lowest point of any box or paw over z = 0, for a robot at `X_WB`.
double LowestPoint(const RobotModel& model, const std::vector<double>& angles_rad,
                   const Eigen::Isometry3d& X_WB);

}  // namespace openr_host
