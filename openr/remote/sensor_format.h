// Formats the sensor values that the remote control sends.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "RemoteProtocol.h"

namespace openr::remote {

class Connection;

// Returns the name of `state`, a MoverState of JointMover, the object that moves the joints.
// Returns "starting" if RCServer, the robot's remote control, does not know the state yet.
std::string StateName(int state);

// Returns the unit in which SensorFormat shows values of `sensor`: "N", "m", "degree C" or "m/s^2".
// Returns "" for a switch and for raw counts of an A/D converter.
std::string SensorUnit(const RcDescription& sensor);

// Formats sensor values with the names and units of the robot's sensors.
class SensorFormat {
 public:
  explicit SensorFormat(Connection* connection);

  nlohmann::ordered_json ToJson(const RcSensors& sensors) const;
  std::string ToText(const RcSensors& sensors) const;

 private:
  std::vector<RcDescription> joints_, binary_, other_;
};

}  // namespace openr::remote
