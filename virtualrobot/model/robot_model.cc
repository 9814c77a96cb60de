#include "virtualrobot/model/robot_model.h"

#include <fmt/format.h>

#include <stdexcept>

#include "runtime/base/spelling.h"

namespace openr_host {
namespace {

template <typename T, typename Match>
int IndexOf(const std::vector<T>& rows, Match match) {
  for (size_t i = 0; i < rows.size(); ++i) {
    if (match(rows[i])) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

const char* SiUnitOf(SensorKind kind) {
  switch (kind) {
    case SensorKind::kJoint:
      return "rad";
    case SensorKind::kForce:
      return "N";
    case SensorKind::kDistance:
      return "m";
    case SensorKind::kTemperature:
      return "deg C";
    case SensorKind::kAcceleration:
      return "m/s^2";
    case SensorKind::kSwitch:
    case SensorKind::kRaw:
      return "";
  }
  return "";
}

int RobotModel::FindBody(std::string_view body_name) const {
  return IndexOf(bodies, [&](const BodyPart& b) { return b.name == body_name; });
}

int RobotModel::FindJoint(std::string_view joint_name) const {
  return IndexOf(joints, [&](const JointModel& j) { return j.name == joint_name; });
}

int RobotModel::FindJointByLocator(std::string_view locator) const {
  return IndexOf(joints, [&](const JointModel& j) { return j.locator == locator; });
}

int RobotModel::FindSensorByLocator(std::string_view locator) const {
  return IndexOf(sensors, [&](const Sensor& s) { return s.locator == locator; });
}

std::vector<int> RobotModel::SensorsNamed(std::string_view wanted) const {
  std::vector<int> group;
  for (size_t i = 0; i < sensors.size(); ++i) {
    const Sensor& sensor = sensors[i];
    const std::string& short_name =
        sensor.joint >= 0 ? joints[static_cast<size_t>(sensor.joint)].name : sensor.short_name;
    if (EqualsIgnoringCase(short_name, wanted) || EqualsIgnoringCase(sensor.name, wanted) ||
        sensor.locator == wanted)
      return {static_cast<int>(i)};
    if (sensor.joint < 0 && short_name.size() > wanted.size() && short_name[wanted.size()] == '_' &&
        EqualsIgnoringCase(short_name.substr(0, wanted.size()), wanted))
      group.push_back(static_cast<int>(i));
  }
  return group;
}

int RobotModel::JointNamed(std::string_view wanted) const {
  const std::vector<int> found = SensorsNamed(wanted);
  return found.size() == 1 ? sensors[static_cast<size_t>(found[0])].joint : -1;
}

const std::vector<double>& RobotModel::PostureAngles(std::string_view posture_name) const {
  std::string known;
  for (const Posture& posture : postures) {
    if (posture.name == posture_name) return posture.angles_rad;
    known += (known.empty() ? "" : ", ") + posture.name;
  }
  throw std::runtime_error(
      fmt::format("{}: no posture '{}'; the model has {}", name, posture_name, known));
}

double RobotModel::TotalMassKg() const {
  double sum_kg = 0;
  for (const BodyPart& body : bodies) sum_kg += body.mass_kg;
  return sum_kg;
}

}  // namespace openr_host
