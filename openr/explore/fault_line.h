// Faults that an exploration may give to a robot, written as inputs.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

struct RobotModel;

// Returns the input (docs/inputs.md) of fault number `number` of a robot: a fault of one joint or
// sensor that ends after 0.1 to 5 s.  Equal numbers give equal inputs.
std::string FaultLine(const RobotModel& model, int64_t number);

}  // namespace openr_host
