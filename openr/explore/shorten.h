// Shortens a list of deviations to those deviations that are needed to break a property.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace openr_host {

// A function that repeats a run which has broken a property, but with fewer deviations: with the
// list `script` of changes of the order and of the times of messages.  Returns the JSON report of
// that run if it breaks the same property as the original run, else nullopt.
using StillBreaks =
    std::function<std::optional<nlohmann::ordered_json>(const nlohmann::ordered_json& script)>;

// Removes deviations from `script` as long as the property stays broken, first many at a time and
// then fewer (delta debugging, Zeller and Hildebrandt); then makes delays and costs smaller.  Sets
// `answer` to the answer of the run with the new `script`.  Returns the number of runs made, at
// most `runs_max`.  Unless that limit was reached, no single one of the remaining deviations could
// be removed.
int Shorten(const StillBreaks& still_breaks, int runs_max, nlohmann::ordered_json* script,
            nlohmann::ordered_json* answer);

}  // namespace openr_host
