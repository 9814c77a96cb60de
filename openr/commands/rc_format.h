// How answers of the remote control look to people and to programs.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "RemoteProtocol.h"

namespace openr_host {

class RemoteClient;

// "frame 1234:"; before the first sensor values "frame -:".
std::string FrameText(uint32_t frame);
// The number, or null.
nlohmann::ordered_json FrameJson(uint32_t frame);

// What the robot does: the name of a MoverState; "starting" while RCServer has not heard of one.
std::string StateName(int state);

// Sensor values with the names and units the robot gives them.
class SensorFormat {
 public:
  explicit SensorFormat(RemoteClient* client);

  nlohmann::ordered_json ToJson(const RcSensors& sensors) const;
  std::string ToText(const RcSensors& sensors) const;

 private:
  std::vector<RcDescription> joints_, binary_, other_;
};

}  // namespace openr_host
