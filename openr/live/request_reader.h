// Reads the members of requests that other programs send to a run or to the server of the panel.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "virtualrobot/base/json_reader.h"

namespace openr_host {

// Returns a reader of `request`, whose refusals name the member of the request, and what is allowed
// there: "request: period_ms: is -5, must be 8 to 1000".  `request` must outlive the reader.
inline JsonReader RequestReader(const nlohmann::json& request) { return {request, "request"}; }

// Returns the robot that `request` names in its member "robot"; robot 0 without this member.
// Throws std::runtime_error if the run, which has `robot_count` robots, has no such robot.
int RobotOfRequest(const nlohmann::json& request, int robot_count);

}  // namespace openr_host
