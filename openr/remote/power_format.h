// Describes the power and the battery of a robot for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "RemoteProtocol.h"

namespace openr::remote {

// Return whether the motors have power, and whether the robot is on its charging station.
bool HasMotorPower(const RcPower& power);
bool IsOnStation(const RcPower& power);

// Returns the answer to POWER (docs/remote-control.md) as JSON: volts, amperes, degrees Celsius,
// and the two status words of the SDK.
nlohmann::ordered_json PowerJson(const RcPower& power);

}  // namespace openr::remote
