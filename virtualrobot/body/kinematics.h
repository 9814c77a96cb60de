// Computes the poses of a robot's parts for given joint angles, and the pose in which the robot
// rests on a flat floor.
//
// All results depend on the model and the angles only and have the same bits in every build,
// because the code uses det_math.h, and Eigen without vectorization.  W is the world frame, B the
// base frame of the robot.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {

// Returns the pose X_BL of each part at `angles_rad`, in the order of RobotModel::bodies.  The
// frame L of a part moves with the part, and coincides with the base frame B when all angles are 0.
// The model file gives the points of the part in L.  REQUIRES: one angle per joint.
std::vector<Eigen::Isometry3d> LinkPoses(const RobotModel& model,
                                         const std::vector<double>& angles_rad);

// The pose of a stiff robot that rests on the floor z = 0.
struct RestingPose {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  // pose of the robot; x, y and yaw are 0
  std::vector<bool> paws;  // whether each paw is on the floor; order of RobotModel::paws
};

// Computes how a robot with joints fixed at `angles_rad` rests on the floor.  The robot rests on a
// face of its convex hull, which encloses all paws and boxes: the face below its centre of mass.
// Because the search begins with an upright robot, the robot never comes to rest on its back.
RestingPose PlaceOnFloor(const RobotModel& model, const std::vector<double>& angles_rad);

// Returns `X_WB`, turned by the yaw of `start` about the vertical axis through the world's origin,
// and then moved to the place of `start`.  A start at the origin with yaw 0 changes no bit of the
// pose.
Eigen::Isometry3d MovedTo(const StartPlace& start, const Eigen::Isometry3d& X_WB);

// Returns the height over z = 0 of the lowest point of all boxes and paws, for a robot whose base
// frame B has the pose `X_WB` in the world W.
double LowestPoint(const RobotModel& model, const std::vector<double>& angles_rad,
                   const Eigen::Isometry3d& X_WB);

}  // namespace openr_host
