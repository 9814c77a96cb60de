#include "virtualrobot/body/kinematics.h"

#include "virtualrobot/base/rotation.h"
#include "virtualrobot/body/stiff_robot.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;

}  // namespace

std::vector<Isometry3d> LinkPoses(const RobotModel& model, const std::vector<double>& angles_rad) {
  return StiffRobot(model, angles_rad).X_BL();
}

RestingPose PlaceOnFloor(const RobotModel& model, const std::vector<double>& angles_rad) {
  RestingPose pose;
  StiffRobot(model, angles_rad).PlaceOnFloor(&pose);
  return pose;
}

double LowestPoint(const RobotModel& model, const std::vector<double>& angles_rad,
                   const Isometry3d& X_WB) {
  return StiffRobot(model, angles_rad).LowestPoint(X_WB);
}

Isometry3d MovedTo(const StartPlace& start, const Isometry3d& X_WB) {
  Isometry3d moved = X_WB;
  if (start.yaw_rad != 0) {
    const Matrix3d turn = RotationFromRpy({0, 0, start.yaw_rad});
    moved.linear() = turn * X_WB.linear();
    moved.translation() = turn * X_WB.translation();
  }
  moved.translation().x() += start.x_m;
  moved.translation().y() += start.y_m;
  return moved;
}

}  // namespace openr_host
