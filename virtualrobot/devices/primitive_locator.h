// Finds the locator of a primitive without making a PrimitiveTable, which allocates memory for
// every primitive of the robot.
#pragma once

#include <OPENR/OPENR.h>

#include <string>

namespace openr_host {

struct RobotModel;

// Returns the locator of the primitive that has the id `id` in the PrimitiveTable of a robot of
// `model`; null if such a robot has no such primitive.  The result is valid as long as `model`.
const std::string* PrimitiveLocator(const RobotModel& model, OPrimitiveID id);

}  // namespace openr_host
