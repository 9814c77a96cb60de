// Formats answers of the remote control as text for people and as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace openr_host {

// Returns "frame 1234:" for `frame`, the frame number of the robot's newest sensor values, which
// each answer of the remote control contains.  Returns "frame -:" if the robot has no sensor values
// yet.
std::string FrameText(uint32_t frame);
// Returns `frame`, the frame number of the robot's newest sensor values, for JSON output; null if
// the robot has no sensor values yet.
nlohmann::ordered_json FrameJson(uint32_t frame);

// A label for answers.  While the label exists, each answer that is printed by the thread of the
// label begins with the address of the robot that has sent it.
class RcRobotLabel {
 public:
  explicit RcRobotLabel(const std::string& address);
  ~RcRobotLabel();
  RcRobotLabel(const RcRobotLabel&) = delete;
  RcRobotLabel& operator=(const RcRobotLabel&) = delete;
};

// Prints an answer of the robot: `text` with the frame number.  With `as_json`, prints one JSON
// object with the frame number and the members of `json`.
void PrintRcAnswer(bool as_json, uint32_t frame, const nlohmann::ordered_json& json,
                   const std::string& text);

}  // namespace openr_host
