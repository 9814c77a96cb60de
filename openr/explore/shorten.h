// Shortens a list of deviations to those deviations that are needed to break a property.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace openr_host {

// A function that runs a script and returns the answer if the run breaks the property in question,
// else nullopt.
using StillBreaks =
    std::function<std::optional<nlohmann::ordered_json>(const nlohmann::ordered_json& script)>;

// Removes deviations of `script` as long as the property stays broken, in large parts first (delta
// debugging, Zeller and Hildebrandt), then makes delays and costs smaller.  Changes `script`, and
// sets `answer` to that of the run with it.  Returns the number of runs, at most `runs_max`.
// Unless that limit was reached, the property holds if any one of the remaining deviations is
// removed.
int Shorten(const StillBreaks& still_breaks, int runs_max, nlohmann::ordered_json* script,
            nlohmann::ordered_json* answer);

}  // namespace openr_host
