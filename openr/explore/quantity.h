// Quantities: values of a run, such as the state of an object or the angle of a joint, that
// property files can name.
#pragma once

#include <functional>
#include <string>
#include <variant>

#include "openr/explore/property.h"

namespace openr_host {

using Value = std::variant<double, std::string>;
using Quantity = std::function<Value(const RunView&)>;

// Returns a function that reads the quantity `name` (docs/exploring.md), such as
// "objects.JointMover.state" or "robots[0].joint.LF_j1".  The name is looked up in `view` now, and
// not again when the function is called.  Throws std::runtime_error when the name is not known.
Quantity FindQuantity(const std::string& name, const RunView& view);

}  // namespace openr_host
