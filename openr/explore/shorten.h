// Shortens a list of deviations to those that are needed to break a property.  A deviation is a
// change that the explorer makes to the order or to the times of the messages in a run.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace openr_host {

// The type of a function that repeats a run which has broken a property, with fewer deviations.
// `script` is the list of these deviations, which are changes of the order and of the times of
// messages.  Returns the JSON report of the new run if it breaks the same property as the original
// run, else nullopt.
using StillBreaks =
    std::function<std::optional<nlohmann::ordered_json>(const nlohmann::ordered_json& script)>;

// Removes deviations from `script` as long as the property stays broken.  First removes many at a
// time and then fewer (delta debugging, Zeller and Hildebrandt).  Then makes delays and costs
// smaller.  Sets `answer` to the answer of the run with the new `script`.  Returns the number of
// runs made, at most `runs_max`.  If fewer than `runs_max` runs were made, none of the remaining
// deviations can be left out alone.
int Shorten(const StillBreaks& still_breaks, int runs_max, nlohmann::ordered_json* script,
            nlohmann::ordered_json* answer);

}  // namespace openr_host
