// A Webots-style controller: what would not work on the robot.
#pragma once

#include <string>
#include <vector>

#include "kit/check.h"

namespace openr_host {

// `locators`: the names that robot_get_device() knows; names are not checked when it is empty.
void CheckController(const std::string& folder, const std::vector<std::string>& locators,
                     Remarks* remarks);

}  // namespace openr_host
