// The fewest deviations that still break a property.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace openr_host {

// The answer of a run with this script when it breaks the property in question, else nothing.
using StillBreaks =
    std::function<std::optional<nlohmann::ordered_json>(const nlohmann::ordered_json& script)>;

// Leaves out deviations of `script` as long as the property breaks, in larger parts first (delta
// debugging, Zeller and Hildebrandt), then makes delays and costs smaller.  Changes `script`, and
// `answer` to that of the run with it.  Returns how many runs it took, `runs_max` at most.
// Without any one of the deviations left the property holds, unless runs_max ended it.
int Shorten(const StillBreaks& still_breaks, int runs_max, nlohmann::ordered_json* script,
            nlohmann::ordered_json* answer);

}  // namespace openr_host
