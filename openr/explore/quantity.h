// What can be asked about a run by name, in property files.
#pragma once

#include <functional>
#include <string>
#include <variant>

#include "openr/explore/property.h"

namespace openr_host {

using Value = std::variant<double, std::string>;
using Quantity = std::function<Value(const RunView&)>;

// The quantity of that name, as in docs/exploring.md: "objects.JointMover.state",
// "robots[0].joint.LF_j1".  Looks the name up in `view` once.  Throws std::runtime_error when
// there is none.
Quantity FindQuantity(const std::string& name, const RunView& view);

}  // namespace openr_host
