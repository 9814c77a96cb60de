// The schedule file, from which openr explore --replay repeats a failing run: the stick and the
// options that were explored, and the deviations from the canonical order that break a property.
//
//   { "openr_explore": 1, "stick": "", "robot": "ers210", "world": "", "body": "ideal",
//     "robots": 1, "strict": false, "guard": true, "cost": "", "battery": "drain",
//     "for_us": 20000000, "properties": ["default"], "seed": 17, "property": "no-drops",
//     "text": "...", "deviations": [ ... ] }
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "openr/simulation/simulation.h"

namespace openr_host {

// The stick and the options of an exploration, without the seed and the order of messages.
struct ExploredStick {
  // The options of the exploration.  A schedule file keeps only stick, robot, world, body, robots,
  // strict, guard_regions, cost_file and battery of these options.
  SimulationOptions simulation;
  int64_t for_us = 20'000'000;
  std::vector<std::string> properties = {"default"};
};

nlohmann::ordered_json ScheduleToJson(const ExploredStick& stick,
                                      const nlohmann::ordered_json& failure);

struct ScheduleFile {
  ExploredStick stick;
  uint64_t seed = 1;
  std::string property;
  std::string text;
};

// Reads a schedule file.  Puts its list "deviations" into `deviations`, and returns the rest.  If
// the file has an error, throws std::runtime_error with the name of the file and the error.
ScheduleFile ReadScheduleFile(const std::string& path, nlohmann::ordered_json* deviations);

// Returns a text about a failure for a human reader: the seed, the broken property, the time, how
// the property is broken, the deviations, the objects that wait and the last messages.
std::string DescribeFailure(const nlohmann::ordered_json& failure);

}  // namespace openr_host
