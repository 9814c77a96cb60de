// Quantities of a run that property files can name.
#pragma once

#include <functional>
#include <string>
#include <variant>

#include "openr/explore/property.h"

namespace openr_host {

using Value = std::variant<double, std::string>;
using Quantity = std::function<Value(const RunView&)>;

// Returns the function that reads the quantity `name` (docs/exploring.md):
// "objects.JointMover.state", "robots[0].joint.LF_j1".  The name is looked up in `view` only once,
// now.  Throws std::runtime_error when it is not known.
Quantity FindQuantity(const std::string& name, const RunView& view);

}  // namespace openr_host
