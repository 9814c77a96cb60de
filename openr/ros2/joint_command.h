// Checks the commands for joints that come from ROS 2.
#pragma once

#include <map>
#include <string>

#include "distribution/ros2/topics.h"
#include "openr/ros2/joint_client.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// Checks `command`, which came over the network, and reads it into `targets`; the key is the
// joint's number in `model`.  The command may name each joint only once, with a finite position.
// It must give velocities for all of these joints or for none.  Returns "", or the reason why the
// whole command is refused.
std::string ReadJointCommand(const Ros2JointCommand& command, const RobotModel& model,
                             std::map<int, JointTarget>* targets);

}  // namespace openr_host
