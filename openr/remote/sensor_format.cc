#include "openr/remote/sensor_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "MoverState.h"
#include "RobotDescription.h"
#include "openr/remote/connection.h"

namespace openr::remote {
namespace {

using Json = nlohmann::ordered_json;

// The unit in which the values of all sensors of a SensorKind are printed.  A printed value is the
// sensor's value divided by `per_unit`.
struct UnitOfKind {
  int kind;
  const char* unit;
  double per_unit;
};
constexpr UnitOfKind kUnits[] = {
    {sensorkindFORCE, "N", 1e6},
    {sensorkindLENGTH, "m", 1e6},
    {sensorkindTEMPERATURE, "degree C", 1e6},
    {sensorkindACCELERATION, "m/s^2", 1e6},
};

UnitOfKind UnitOf(const RcDescription& sensor) {
  const int kind = sensor.values.empty() ? sensorkindRAW : sensor.values[0];
  const auto* const found = std::find_if(std::begin(kUnits), std::end(kUnits),
                                         [kind](const UnitOfKind& u) { return u.kind == kind; });
  return found == std::end(kUnits) ? UnitOfKind{kind, "", 1} : *found;
}

// Returns a JSON object with a member for each of `values`.  The name of a member is the sensor's
// name in `names`.
Json Values(const std::vector<RcDescription>& names, const std::vector<Sint32>& values) {
  Json json = Json::object();
  for (size_t i = 0; i < std::min(names.size(), values.size()); ++i) {
    json[names[i].name] = values[i];
  }
  return json;
}

}  // namespace

std::string StateName(int state) {
  // Treats 0xff as "starting", because RCServer sends 0xff, -1 in a byte, until JointMover has
  // reported its first state.
  return state == 0xff ? "starting" : MoverStateName(state);
}

std::string SensorUnit(const RcDescription& sensor) { return UnitOf(sensor).unit; }

SensorFormat::SensorFormat(Connection* connection)
    : joints_(connection->Devices(rcdeviceJOINT)),
      binary_(connection->Devices(rcdeviceBINARY)),
      other_(connection->Devices(rcdeviceOTHER)) {}

Json SensorFormat::ToJson(const RcSensors& sensors) const {
  Json other = Json::object();
  for (size_t i = 0; i < std::min(other_.size(), sensors.other.size()); ++i) {
    other[other_[i].name] = sensors.other[i] / UnitOf(other_[i]).per_unit;
  }
  Json json = {{"state", StateName(sensors.state)}};
  json["joints_deg"] = Json::object();
  for (size_t i = 0; i < std::min(joints_.size(), sensors.joints.size()); ++i) {
    json["joints_deg"][joints_[i].name] = sensors.joints[i] / 100.0;
  }
  json["binary"] = Values(binary_, sensors.binary);
  json["other"] = std::move(other);
  if (sensors.misc.size() >= 2) {
    json["battery"] = {{"capacity_percent", sensors.misc[0]},
                       {"temperature_c", sensors.misc[1] / 100.0}};
  }
  json["key_frame"] = sensors.keyFrame.empty() ? -1 : sensors.keyFrame[0];
  return json;
}

std::string SensorFormat::ToText(const RcSensors& sensors) const {
  std::string text = StateName(sensors.state);
  for (size_t i = 0; i < std::min(joints_.size(), sensors.joints.size()); ++i) {
    text += fmt::format("\n  {:<12} {:8.2f} deg", joints_[i].name, sensors.joints[i] / 100.0);
  }
  for (size_t i = 0; i < std::min(binary_.size(), sensors.binary.size()); ++i) {
    text += fmt::format("\n  {:<48} {}", binary_[i].title, sensors.binary[i]);
  }
  for (size_t i = 0; i < std::min(other_.size(), sensors.other.size()); ++i) {
    const UnitOfKind unit = UnitOf(other_[i]);
    text += fmt::format("\n  {:<48} {:.6g} {}", other_[i].title, sensors.other[i] / unit.per_unit,
                        unit.unit);
  }
  if (sensors.misc.size() >= 2) {
    text +=
        fmt::format("\n  battery {} %, {:.2f} degree C", sensors.misc[0], sensors.misc[1] / 100.0);
  }
  if (!sensors.keyFrame.empty() && sensors.keyFrame[0] >= 0) {
    text += fmt::format("\n  key frame {}", sensors.keyFrame[0]);
  }
  return text;
}

}  // namespace openr::remote
