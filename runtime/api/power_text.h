// Describes an OPowerStatus as text, for OPowerStatus::Print() and PrintDetail().
#pragma once

#include <OPENR/OPower.h>

#include <string>
#include <vector>

namespace openr_host {

// Returns one line such as
// "robot 0x00000042, battery 0x0080, 84 %, 25.1 C, 1800 mAh, 7400 mV, -320 mA, UTC+9, volume 2".
std::string PowerSummary(const OPowerStatus& status);

// Returns a line with the constant's name for each bit that is set, then a line for each measured
// value, such as "voltage 7400 mV".
std::vector<std::string> PowerDetails(const OPowerStatus& status);

}  // namespace openr_host
