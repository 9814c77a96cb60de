// The file of a failing run: what was explored, and the order that breaks it.
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

// What was run; seeds and orders aside.
struct ExploredStick {
  // stick, robot, world, body, robots, strict, guard_regions, cost_file, battery
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

// The list under "deviations" goes to `deviations`.  Throws std::runtime_error naming the file and
// what is wrong with it.
ScheduleFile ReadScheduleFile(const std::string& path, nlohmann::ordered_json* deviations);

// For people: property, time, text, the deviations and the last messages.
std::string DescribeFailure(const nlohmann::ordered_json& failure);

}  // namespace openr_host
