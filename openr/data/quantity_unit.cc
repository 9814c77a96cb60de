#include "openr/data/quantity_unit.h"

#include <map>

#include "cli/install_paths.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

struct NamedUnit {
  const char* ending;  // the end of the names of all quantities with this unit
  QuantityUnit unit;
};
constexpr NamedUnit kNamedUnits[] = {{"_deg_s", {"deg/s", 1, 4}}, {"_m_s", {"m/s", 1, 0.02}},
                                     {"_deg", {"deg", 1, 4}},     {"_mm", {"mm", 1, 4}},
                                     {"_m", {"m", 1, 0.02}},      {"_percent", {"%", 1, 2}}};

// Returns the kinds of the sensors of all robots; the key is the short name of a sensor, such as
// "chin".  A short name stands for the same kind in all models of robots.
const std::map<std::string, SensorKind>& SensorKinds() {
  static const std::map<std::string, SensorKind> kinds = [] {
    std::map<std::string, SensorKind> all;
    for (const char* const robot : {"ers210", "ers220", "ers7"}) {
      for (const Sensor& sensor : LoadRobotModel(ModelFile(robot)).sensors)
        all.emplace(sensor.short_name, sensor.kind);
    }
    return all;
  }();
  return kinds;
}

// Returns the unit in which charts show the values of sensors of the kind `kind`.
QuantityUnit UnitOfSensor(SensorKind kind) {
  const char* const text = SiUnitOf(kind);
  switch (kind) {
    case SensorKind::kSwitch:
    case SensorKind::kRaw:
      return {text, 1, 1};
    case SensorKind::kAcceleration:
      return {text, 1e-6, 0.2};
    case SensorKind::kTemperature:
      return {text, 1e-6, 2};
    case SensorKind::kJoint:
    case SensorKind::kForce:
    case SensorKind::kDistance:
      break;
  }
  return {text, 1e-6, 0.02};
}

// Returns the short name of the sensor whose values the quantity `name` has; "" if the quantity is
// not the value of a sensor.
std::string SensorOfQuantity(const std::string& name) {
  const size_t begin = name.starts_with("robots[") ? name.find("].") + 2 : 0;
  const std::string group = "sensor.";
  return name.compare(begin, group.size(), group) == 0 ? name.substr(begin + group.size()) : "";
}

}  // namespace

QuantityUnit UnitOfQuantity(const std::string& name) {
  if (const std::string sensor = SensorOfQuantity(name); !sensor.empty()) {
    const auto kind = SensorKinds().find(sensor);
    if (kind != SensorKinds().end()) return UnitOfSensor(kind->second);
  }
  for (const NamedUnit& named : kNamedUnits) {
    if (name.ends_with(named.ending)) return named.unit;
  }
  return {"", 1, 1e-6};
}

}  // namespace openr_host
