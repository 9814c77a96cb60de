// Describes the power and the battery of a robot as JSON, which programs can read.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "RemoteProtocol.h"

namespace openr::remote {

// Returns whether the robot's motors have power.
bool HasMotorPower(const RcPower& power);
// Returns whether the robot is on its charging station.
bool IsOnStation(const RcPower& power);

// Returns `power`, the robot's answer to POWER (docs/remote-control.md), as JSON: volts, amperes,
// degrees Celsius, and the two status words of the SDK.
nlohmann::ordered_json PowerJson(const RcPower& power);

}  // namespace openr::remote
