// Formats answers of the remote control for people and as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "RemoteProtocol.h"

namespace openr_host {

class RemoteClient;

// Returns the frame number of an answer as "frame 1234:".  Returns "frame -:" before the robot has
// sensor values.
std::string FrameText(uint32_t frame);
// Returns the frame number of an answer as JSON; null before the robot has sensor values.
nlohmann::ordered_json FrameJson(uint32_t frame);

// Returns the name of the MoverState `state`.  Returns "starting" while RCServer, the robot's
// remote control, has received no state yet.
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
