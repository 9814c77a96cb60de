// Loads cost files (--cost), which say how much processor time handlers take.
#pragma once

#include <optional>
#include <string>

#include "runtime/config/cost_config.h"

namespace openr_host {

// Reads the cost file `name`.  `name` may also be a file that came with openr, such as
// "ers210.cost".  Returns nullopt for "" and "zero", which mean that handlers take no time.  Throws
// std::runtime_error with all errors of the file.
std::optional<CostConfig> LoadCostFile(const std::string& name);

}  // namespace openr_host
