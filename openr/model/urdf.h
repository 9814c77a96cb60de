// A robot model as URDF, the format in which ROS and many simulators describe robots.
#pragma once

#include <string>

#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// Returns the text of a URDF file.  Each part is a link with its box, its mass and the inertia of
// uniform density; a paw is a ball at the end of its shin.  Each joint is revolute.  Its limits are
// the mechanical stops, the stall torque, and the highest speed that the model allows for set
// points.  The frame of a link has its origin at the link's joint, and is parallel to the base
// frame B when all angles are 0.  A part whose box is not known is a link without shape and
// inertia.  Two frames without mass are added: "base_link", the root, which is B, and
// "camera_optical", the frame of the camera's pictures.
std::string Urdf(const RobotModel& model);

}  // namespace openr_host
