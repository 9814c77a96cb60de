// Checks messages of ROS 2 with targets for joints.
#pragma once

#include <map>
#include <string>

#include "distribution/ros2/topics.h"
#include "openr/ros2/joint_client.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// Reads a command that came over the network.  Its joints must be those of `model`, each once, with
// one finite position each, and finite velocities for all or none.  Returns "" and sets the targets
// by joint, or returns the reason why the whole command is refused.
std::string ReadJointCommand(const Ros2JointCommand& command, const RobotModel& model,
                             std::map<int, JointTarget>* targets);

}  // namespace openr_host
