// Models as C++98 tables: the text of RobotConstants.h and RobotConstants.cc.
#pragma once

#include <string>
#include <vector>

#include "model_file.h"

namespace openr_host::genmodel {

std::string HeaderText(const std::vector<Model>& models);

// Throws std::runtime_error for a kind of device that objects/ does not know.
std::string SourceText(const std::vector<Model>& models);

}  // namespace openr_host::genmodel
