// The command openr check: finds faults of a program and its Memory Stick without running it.
#pragma once

#include <string>
#include <vector>

#include "kit/remarks.h"

namespace openr_host {

// The machine that is to run the program.  A host loads images for the host's processor, a robot
// loads images for the robot's processor.
enum class CheckTarget { kHost, kRobot };

// Checks a folder with objects and sticks, or a stick alone.  `locators` are the names of all
// devices of all robots; a device that a controller names must be one of them.  Throws
// std::runtime_error when the folder holds nothing to check.
Remarks CheckFolder(const std::string& folder, const std::vector<std::string>& locators,
                    CheckTarget target = CheckTarget::kHost);

}  // namespace openr_host
