// Finds parts of a Webots-style controller that would not work on the robot.
#pragma once

#include <string>
#include <vector>

#include "kit/remarks.h"

namespace openr_host {

// Checks the controller in `folder`.  `locators` are the names of devices that robot_get_device()
// knows; if the list is empty, the controller's names of devices are not checked.
void CheckController(const std::string& folder, const std::vector<std::string>& locators,
                     Remarks* remarks);

}  // namespace openr_host
