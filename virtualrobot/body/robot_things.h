// The parts of a robot as things that a camera sees.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {

// Returns the boxes and paws of a robot whose parts have the poses `X_WL` (Body::BodyPoses()), in
// the colours of an ERS-210.  Leaves out parts for which `is_left_out` is true.  Leaves out parts
// of 2 mm or less too, because the model has them only to connect two joints, and a real robot
// shows no such part.  REQUIRES: `X_WL` and `is_left_out` have one element per part.
std::vector<WorldThing> ThingsOfRobot(const RobotModel& model,
                                      const std::vector<Eigen::Isometry3d>& X_WL,
                                      const std::vector<bool>& is_left_out);

}  // namespace openr_host
