// A Webots-style controller: what would not work on the robot.
#pragma once

#include <string>

#include "openr/kit/check.h"

namespace openr_host {

void CheckController(const std::string& folder, Remarks* remarks);

}  // namespace openr_host
