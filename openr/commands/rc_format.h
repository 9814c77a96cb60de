// Formats answers of the remote control for people and as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "RemoteProtocol.h"

namespace openr_host {

class RemoteClient;

// Returns "frame 1234:" for `frame`, the frame number of the robot's newest sensor values, which
// each answer of the remote control contains.  Returns "frame -:" if the robot has no sensor values
// yet.
std::string FrameText(uint32_t frame);
// Returns `frame`, the frame number of the robot's newest sensor values, for JSON output; null if
// the robot has no sensor values yet.
nlohmann::ordered_json FrameJson(uint32_t frame);

// Prints an answer of the robot: `text` with the frame number, or with `as_json` one JSON object of
// frame number and `json`.
void PrintRcAnswer(bool as_json, uint32_t frame, const nlohmann::ordered_json& json,
                   const std::string& text);

// Returns the name of `state`, a MoverState of JointMover, the object that moves the joints.
// Returns "starting" if RCServer, the robot's remote control, does not know the state yet.
std::string StateName(int state);

// Formats sensor values with the names and units of the robot's sensors.
class SensorFormat {
 public:
  explicit SensorFormat(RemoteClient* client);

  nlohmann::ordered_json ToJson(const RcSensors& sensors) const;
  std::string ToText(const RcSensors& sensors) const;

 private:
  std::vector<RcDescription> joints_, binary_, other_;
};

}  // namespace openr_host
