// Describes the robots of a run, and their world, for a program that draws them (docs/inputs.md,
// "The socket of a run").
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "openr/simulation/simulation.h"

namespace openr_host {

// Returns everything about the robots that does not change in a run: parts with their shapes,
// joints with their limits, lights, ears and sensors.
nlohmann::ordered_json SceneJson(const Simulation& simulation);

// Returns the present poses of parts and states of lights and ears, as the text of the members
// "time_s" and "robots" of a JSON object.
std::string PoseText(Simulation* simulation);

// Returns the present values of joints, sensors and battery of all robots.
nlohmann::ordered_json ValuesJson(Simulation* simulation);

}  // namespace openr_host
