// Shows what a robot model has, as tables for people: openr model show.
#pragma once

#include <string>

#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// Returns tables of the joints with their limits, and of the other sensors, lights, ears, camera,
// speaker and microphone.  Each has its locator.  Also returns the names of the postures.  Joints
// and sensors are in the order of the model; their lines have the index of their values in sensor
// vectors ("element").
std::string ShowModel(const RobotModel& model);

}  // namespace openr_host
