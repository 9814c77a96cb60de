// What a message of ROS 2 asks of a robot's joints.
#pragma once

#include <map>
#include <string>

#include "distribution/ros2/topics.h"
#include "openr/ros2/joint_client.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// Looks at a command that came over the network: its joints are those of `model`, each once, with
// one finite position each, and finite velocities for all or none.  Returns "" and the targets by
// joint, or why the whole of it is refused.
std::string ReadJointCommand(const Ros2JointCommand& command, const RobotModel& model,
                             std::map<int, JointTarget>* targets);

}  // namespace openr_host
