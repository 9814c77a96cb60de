// Cost files for --cost.
#pragma once

#include <optional>
#include <string>

#include "runtime/config/cost_config.h"

namespace openr_host {

// Reads the file, or the one of that name that came with the program ("ers210.cost").  Nothing for
// "" and "zero": handlers take no time.  Throws std::runtime_error with every wrong line.
std::optional<CostConfig> LoadCostFile(const std::string& name);

}  // namespace openr_host
