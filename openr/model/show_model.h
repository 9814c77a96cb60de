// Shows what a robot model has, as tables for people: openr model show.
#pragma once

#include <string>

#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// Returns tables of the joints with their limits, and of the other sensors, lights, ears, camera,
// speaker and microphone, each with its locator.  Also returns the names of the postures.  The
// tables of joints and of sensors have the order of the model; their column "element" has the index
// of the joint's or sensor's value in sensor vectors.
std::string ShowModel(const RobotModel& model);

}  // namespace openr_host
