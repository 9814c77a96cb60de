// Writes robot models as C++98 tables: the text of RobotConstants.h and RobotConstants.cc.
#pragma once

#include <string>
#include <vector>

#include "robot_tables.h"

namespace openr_host::genmodel {

std::string HeaderText(const std::vector<RobotTables>& robots);

// Returns the text of RobotConstants.cc.  Throws std::runtime_error for a kind of device that
// objects/ does not know.
std::string SourceText(const std::vector<RobotTables>& robots);

}  // namespace openr_host::genmodel
