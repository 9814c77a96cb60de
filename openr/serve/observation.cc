#include "openr/serve/observation.h"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "openr/simulation/simulation.h"
#include "runtime/base/spelling.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/body/kinematics.h"

namespace openr_host {
namespace {

constexpr std::string_view kRobots = "robots[";

// The name of a value, split into the number of the robot and the rest: "robots[1].joints" is
// "joints" of robot 1.
struct RobotValueName {
  size_t robot = 0;
  std::string rest;
};

RobotValueName SplitRobot(const std::string& name, const RunView& view) {
  RobotValueName result{0, name};
  if (name.starts_with(kRobots)) {
    const char* const begin = name.data() + kRobots.size();
    const char* const end = name.data() + name.size();
    const auto [at, error] = std::from_chars(begin, end, result.robot);
    if (error != std::errc() ||
        !std::string_view(at, static_cast<size_t>(end - at)).starts_with("]."))
      throw std::runtime_error(fmt::format("'{}': write robots[0].joints", name));
    result.rest = std::string(at + 2, end);
  }
  if (result.robot >= view.prepared->robots.size())
    throw std::runtime_error(fmt::format("'{}': there is no robot {}", name, result.robot));
  return result;
}

const BodyState& StateOf(const RunView& view, size_t robot) {
  return view.prepared->robots[robot]->body().state();
}

size_t JointIndex(const RobotModel& model, const std::string& name) {
  const int joint = model.JointNamed(name);
  if (joint >= 0) return static_cast<size_t>(joint);
  std::vector<std::string> known;
  for (const JointModel& each : model.joints) known.push_back(each.name);
  throw std::runtime_error(fmt::format("no joint '{}'{}", name, DidYouMean(name, known)));
}

Quantity TargetOf(size_t robot, size_t joint) {
  return [=](const RunView& view) -> Value {
    return Degrees(view.prepared->robots[robot]->devices().joints[joint].target_urad * 1e-6);
  };
}

Quantity AngleOf(size_t robot, size_t joint) {
  return [=](const RunView& view) -> Value {
    return Degrees(StateOf(view, robot).joints[joint].angle_rad);
  };
}

// Returns the quantity for the angle that the sensor of a joint measures, in degrees.
Quantity MeasuredOf(size_t robot, size_t joint) {
  return [=](const RunView& view) -> Value {
    const VirtualRobot& dog = *view.prepared->robots[robot];
    return Degrees(dog.sensor(dog.model().joints[joint].sensor).value * 1e-6);
  };
}

Quantity SpeedOf(size_t robot, size_t joint) {
  return [=](const RunView& view) -> Value {
    return Degrees(StateOf(view, robot).joints[joint].speed_rad_s);
  };
}

Quantity DriveOf(size_t robot, size_t joint) {
  return [=](const RunView& view) -> Value { return StateOf(view, robot).joints[joint].drive; };
}

Quantity SensorOf(size_t robot, int sensor) {
  return [=](const RunView& view) -> Value {
    return static_cast<double>(view.prepared->robots[robot]->sensor(sensor).value);
  };
}

Quantity PawOf(size_t robot, size_t paw) {
  return [=](const RunView& view) -> Value { return StateOf(view, robot).paws[paw] ? 1.0 : 0.0; };
}

// Returns the quantity for a velocity of the robot's base B (virtualrobot/body/body.h): along an
// axis of the world, or around one of the base's own axes (angular velocity).
Quantity MotionOf(size_t robot, const std::string& name) {
  static const std::map<std::string, int> axes = {{"vx_m_s", 0},   {"vy_m_s", 1},
                                                  {"vz_m_s", 2},   {"wx_deg_s", 3},
                                                  {"wy_deg_s", 4}, {"wz_deg_s", 5}};
  const auto found = axes.find(name);
  if (found == axes.end()) return {};
  const int axis = found->second;
  if (axis < 3)
    return [=](const RunView& view) -> Value { return StateOf(view, robot).v_WB[axis]; };
  return [=](const RunView& view) -> Value {
    const BodyState& state = StateOf(view, robot);
    const Eigen::Vector3d w_B = state.X_WB.linear().transpose() * state.w_WB;
    return Degrees(w_B[axis - 3]);
  };
}

using JointQuantity = Quantity (*)(size_t robot, size_t joint);
struct JointKind {
  const char* one;
  const char* all;
  JointQuantity make;
};
constexpr JointKind kJointKinds[] = {{"joint", "joints", &AngleOf},
                                     {"target", "targets", &TargetOf},
                                     {"measured", "measured", &MeasuredOf},
                                     {"speed", "speeds", &SpeedOf},
                                     {"drive", "drives", &DriveOf}};

std::vector<ReadValue> FindGroup(const RobotValueName& wanted, const RobotModel& model) {
  std::vector<ReadValue> values;
  const auto add = [&](const std::string& kind, const std::string& name, Quantity read) {
    values.push_back({fmt::format("robots[{}].{}.{}", wanted.robot, kind, name), std::move(read)});
  };
  for (const JointKind& kind : kJointKinds) {
    if (wanted.rest != kind.all) continue;
    for (size_t j = 0; j < model.joints.size(); ++j)
      add(kind.one, model.joints[j].name, kind.make(wanted.robot, j));
  }
  for (size_t i = 0; wanted.rest == "sensors" && i < model.sensors.size(); ++i) {
    // Leaves out the sensors of joints, because the group of values "measured" has them.
    if (model.sensors[i].joint < 0)
      add("sensor", model.sensors[i].short_name, SensorOf(wanted.robot, static_cast<int>(i)));
  }
  for (size_t i = 0; wanted.rest == "paws" && i < model.paws.size(); ++i)
    add("paw", model.paws[i].leg, PawOf(wanted.robot, i));
  return values;
}

// Returns the quantity with the name `wanted` if this source file defines it, such as
// "speed.JOINT"; otherwise returns null, and the caller then asks FindQuantity().
Quantity FindOwn(const RobotValueName& wanted, const RobotModel& model) {
  const size_t dot = wanted.rest.find('.');
  if (dot == std::string::npos) return MotionOf(wanted.robot, wanted.rest);
  const std::string kind = wanted.rest.substr(0, dot), name = wanted.rest.substr(dot + 1);
  for (const JointKind& each : kJointKinds) {
    if (kind == each.one) return each.make(wanted.robot, JointIndex(model, name));
  }
  if (kind == "sensor") {
    const std::vector<int> sensors = model.SensorsNamed(name);
    if (sensors.size() == 1) return SensorOf(wanted.robot, sensors[0]);
  }
  for (size_t i = 0; kind == "paw" && i < model.paws.size(); ++i) {
    if (model.paws[i].leg == name) return PawOf(wanted.robot, i);
  }
  return {};
}

}  // namespace

std::vector<ReadValue> FindValues(const std::string& name, const RunView& view) {
  const bool is_of_run =
      name == "messages" || name.starts_with("findings.") || name.starts_with("objects.");
  if (is_of_run) return {{name, FindQuantity(name, view)}};
  const RobotValueName wanted = SplitRobot(name, view);
  const RobotModel& model = view.prepared->robots[wanted.robot]->model();
  std::vector<ReadValue> group = FindGroup(wanted, model);
  if (!group.empty()) return group;
  const std::string full = fmt::format("robots[{}].{}", wanted.robot, wanted.rest);
  Quantity own = FindOwn(wanted, model);
  return {{full, own ? std::move(own) : FindQuantity(full, view)}};
}

void Observation::Choose(const std::vector<std::string>& names, const RunView& view) {
  std::vector<ReadValue> values;
  for (const std::string& name : names) {
    for (ReadValue& value : FindValues(name, view)) {
      if (!std::holds_alternative<double>(value.read(view)))
        throw std::runtime_error(fmt::format("'{}' is a text; observe has numbers only", name));
      values.push_back(std::move(value));
    }
  }
  // Replaces the old values only after all names were found, so that a wrong name changes nothing.
  values_ = std::move(values);
}

std::string Observation::Bytes(const RunView& view) const {
  std::string bytes(values_.size() * sizeof(double), '\0');
  auto* const numbers = reinterpret_cast<double*>(bytes.data());
  for (size_t i = 0; i < values_.size(); ++i) numbers[i] = std::get<double>(values_[i].read(view));
  return bytes;
}

}  // namespace openr_host
