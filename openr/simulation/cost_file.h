// Loads cost files for --cost.
#pragma once

#include <optional>
#include <string>

#include "runtime/config/cost_config.h"

namespace openr_host {

// Reads the file `name`, or the file of that name that came with the program ("ers210.cost").
// Returns nullopt for "" and "zero", with which handlers take no time.  Throws std::runtime_error
// with all errors.
std::optional<CostConfig> LoadCostFile(const std::string& name);

}  // namespace openr_host
