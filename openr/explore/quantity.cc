#include "openr/explore/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "runtime/base/spelling.h"
#include "runtime/core/system.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/rotation.h"

namespace openr_host {
namespace {

constexpr size_t kNone = std::string::npos;

[[noreturn]] void Unknown(const std::string& what, const std::string& name,
                          const std::vector<std::string>& known) {
  throw std::runtime_error(fmt::format("no {} '{}'{}", what, name, DidYouMean(name, known)));
}

struct ObjectField {
  const char* name;
  Value (*of)(const Object& object);
};

constexpr ObjectField kOfObject[] = {
    {"state", [](const Object& object) -> Value { return object.statistics().state(); }},
    {"messages",
     [](const Object& object) -> Value { return static_cast<double>(object.message_count()); }},
    {"dropped",
     [](const Object& object) -> Value {
       return static_cast<double>(object.statistics().dropped_count());
     }},
    {"queue_max",
     [](const Object& object) -> Value { return static_cast<double>(object.waiting_max()); }}};

// Returns the quantity `field` of an object.  Looks the object up at each reading, because the
// object is replaced when the robot boots or when the object's image is loaded again.  If a boot
// has not loaded the object again, its state is "absent", and its numbers are NaN.
Quantity OfObject(int robot, const std::string& object_name, const std::string& field) {
  std::vector<std::string> known;
  for (const ObjectField& each : kOfObject) known.push_back(each.name);
  const auto found = std::find(known.begin(), known.end(), field);
  if (found == known.end()) Unknown("field of an object", field, known);
  return [robot, object_name, of = kOfObject[found - known.begin()].of,
          is_text = field == "state"](const RunView& view) -> Value {
    const Object* const object = view.prepared->system->FindObject(robot, object_name);
    if (object != nullptr) return of(*object);
    return is_text ? Value("absent") : Value(std::numeric_limits<double>::quiet_NaN());
  };
}

// Returns the quantity `name`, which is a field of an object.  `name` has the name of the object
// and the name of the field, such as "JointMover.state".
Quantity FindInObjects(const System& system, int robot, const std::string& name) {
  const size_t dot = name.rfind('.');
  if (dot == kNone)
    throw std::runtime_error(fmt::format("'{}' has no field; write objects.NAME.state", name));
  const std::string object_name = name.substr(0, dot);
  if (system.FindObject(robot, object_name) != nullptr)
    return OfObject(robot, object_name, name.substr(dot + 1));
  std::vector<std::string> known;
  for (const auto& each : system.objects()) {
    if (each->robot == robot) known.push_back(each->name);
  }
  Unknown(fmt::format("object of robot {}", robot), object_name, known);
}

// Returns the index of a joint in the model.  `name` is the joint's name in the model, such as
// "LF_j1", or its locator, which is the joint's name in OPEN-R.
size_t JointOf(const RobotModel& model, const std::string& name) {
  int joint = model.FindJoint(name);
  if (joint < 0) joint = model.FindJointByLocator(name);
  if (joint < 0) {
    std::vector<std::string> known;
    for (const JointModel& each : model.joints) known.push_back(each.name);
    Unknown("joint", name, known);
  }
  return static_cast<size_t>(joint);
}

// Returns the quantity "joint": the angle of a joint of the simulated body, in degrees.
Quantity FindJoint(const RobotModel& model, size_t robot, const std::string& name) {
  return [robot, index = JointOf(model, name)](const RunView& view) -> Value {
    return Degrees(view.prepared->robots[robot]->body().state().joints[index].angle_rad);
  };
}

// Returns the quantity "command": the set point of a joint, in degrees; NaN before the first
// command.
Quantity FindCommand(const RobotModel& model, size_t robot, const std::string& name) {
  return [robot, index = JointOf(model, name)](const RunView& view) -> Value {
    const JointDevice& joint = view.prepared->robots[robot]->devices().joints[index];
    return joint.commanded ? Degrees(joint.target_urad * 1e-6)
                           : std::numeric_limits<double>::quiet_NaN();
  };
}

// Returns the quantity "measured": the angle that the sensor of a joint measures, in degrees.
Quantity FindMeasured(const RobotModel& model, size_t robot, const std::string& name) {
  const int sensor = model.joints[JointOf(model, name)].sensor;
  if (sensor < 0) throw std::runtime_error(fmt::format("joint '{}' has no sensor", name));
  return [robot, sensor](const RunView& view) -> Value {
    return Degrees(view.prepared->robots[robot]->sensor(sensor).value * 1e-6);
  };
}

// Returns the quantity "sensor": the value of a sensor in OPEN-R's unit.  `name` is the sensor's
// short name, such as "chin", or its locator, which is the sensor's name in OPEN-R.
Quantity FindSensor(const RobotModel& model, size_t robot, const std::string& name) {
  const std::vector<int> found = model.SensorsNamed(name);
  if (found.size() != 1) {
    std::vector<std::string> known;
    for (const Sensor& each : model.sensors)
      known.push_back(each.short_name.empty() ? each.locator : each.short_name);
    Unknown("sensor", name, known);
  }
  return [robot, sensor = found.front()](const RunView& view) -> Value {
    return static_cast<double>(view.prepared->robots[robot]->sensor(sensor).value);
  };
}

// Returns the horizontal direction in which a robot looks, as a unit vector.
Eigen::Vector3d HeadingOf(const BodyState& state) {
  const Eigen::Vector3d x = state.X_WB.linear().col(0);
  const double length = std::sqrt(x.x() * x.x() + x.y() * x.y());
  if (length < 1e-9) return {1, 0, 0};  // the robot looks up or down, so it has no heading
  return {x.x() / length, x.y() / length, 0};
}

double RpyDegrees(const BodyState& state, int index) {
  return Degrees(RpyOf(state.X_WB.linear())[index]);
}

struct BaseQuantity {
  const char* name;
  double (*of)(const BodyState& state);
};

// The quantities of a robot's base B (virtualrobot/body/body.h): its place, its attitude and its
// speeds.  The speeds are in the robot's own directions: forward and left along the floor, up, and
// the rate at which it turns left.
constexpr BaseQuantity kOfBase[] = {
    {"x_m", [](const BodyState& s) -> double { return s.X_WB.translation().x(); }},
    {"y_m", [](const BodyState& s) -> double { return s.X_WB.translation().y(); }},
    {"height_mm", [](const BodyState& s) -> double { return s.X_WB.translation().z() * 1e3; }},
    {"roll_deg", [](const BodyState& s) { return RpyDegrees(s, 0); }},
    {"pitch_deg", [](const BodyState& s) { return RpyDegrees(s, 1); }},
    {"yaw_deg", [](const BodyState& s) { return RpyDegrees(s, 2); }},
    {"forward_m_s", [](const BodyState& s) -> double { return HeadingOf(s).dot(s.v_WB); }},
    {"left_m_s",
     [](const BodyState& s) -> double {
       const Eigen::Vector3d ahead = HeadingOf(s);
       return ahead.x() * s.v_WB.y() - ahead.y() * s.v_WB.x();
     }},
    {"up_m_s", [](const BodyState& s) -> double { return s.v_WB.z(); }},
    {"turn_deg_s", [](const BodyState& s) { return Degrees(s.w_WB.z()); }},
};

// Returns the quantity for the place of a thing that can move, in the world of a robot.  `name` has
// the name of the thing and an axis, such as "ball.x_m".
Quantity FindThing(const VirtualRobot& of_robot, size_t robot, const std::string& name) {
  const std::vector<std::string> axes = {"x_m", "y_m", "z_m"};
  const size_t dot = name.rfind('.');
  if (dot == kNone) throw std::runtime_error(fmt::format("'{}': write thing.NAME.x_m", name));
  const auto axis = std::find(axes.begin(), axes.end(), name.substr(dot + 1));
  if (axis == axes.end()) Unknown("axis", name.substr(dot + 1), axes);
  const std::vector<WorldThing> things = of_robot.body().MovableThings();
  std::vector<std::string> known;
  for (const WorldThing& thing : things) known.push_back(thing.name);
  const auto thing = std::find(known.begin(), known.end(), name.substr(0, dot));
  if (thing == known.end()) Unknown("movable thing", name.substr(0, dot), known);
  return [robot, index = static_cast<size_t>(thing - known.begin()),
          row = axis - axes.begin()](const RunView& view) -> Value {
    return view.prepared->robots[robot]->body().MovableThings()[index].centre_m[row];
  };
}

Quantity FindInRobot(const RunView& view, size_t robot, const std::string& name) {
  const RobotModel& model = view.prepared->robots[robot]->model();
  if (name.starts_with("objects.")) {
    return FindInObjects(*view.prepared->system, static_cast<int>(robot), name.substr(8));
  }
  if (name.starts_with("joint.")) return FindJoint(model, robot, name.substr(6));
  if (name.starts_with("sensor.")) return FindSensor(model, robot, name.substr(7));
  if (name.starts_with("thing."))
    return FindThing(*view.prepared->robots[robot], robot, name.substr(6));
  if (name.starts_with("command.")) return FindCommand(model, robot, name.substr(8));
  if (name.starts_with("measured.")) return FindMeasured(model, robot, name.substr(9));
  if (name == "standing") {
    return [robot](const RunView& now) -> Value {
      return std::string((*now.standing)[robot].standing() ? "true" : "false");
    };
  }
  if (name == "battery_percent") {
    return [robot](const RunView& now) -> Value {
      return static_cast<double>(now.prepared->robots[robot]->power().remaining_percent());
    };
  }
  for (const BaseQuantity& base : kOfBase) {
    if (name != base.name) continue;
    return [robot, of = base.of](const RunView& now) -> Value {
      return of(now.prepared->robots[robot]->body().state());
    };
  }
  std::vector<std::string> known = {"standing",       "battery_percent",   "joint.NAME",
                                    "command.NAME",   "measured.NAME",     "sensor.NAME",
                                    "thing.NAME.x_m", "objects.NAME.state"};
  for (const BaseQuantity& base : kOfBase) known.push_back(base.name);
  Unknown("quantity of a robot", name, known);
}

// Returns whether `name` begins like the short name of a quantity of robot 0, which has no
// "robots[0]." in front.
bool IsOfFirstRobot(const std::string& name) {
  for (const char* const begin : {"joint.", "command.", "measured.", "sensor.", "thing."}) {
    if (name.starts_with(begin)) return true;
  }
  if (name == "standing" || name == "battery_percent") return true;
  return std::any_of(std::begin(kOfBase), std::end(kOfBase),
                     [&](const BaseQuantity& base) { return name == base.name; });
}

Quantity FindingCount(Severity severity) {
  return [severity](const RunView& view) -> Value {
    double count = 0;
    for (const Finding& finding : view.prepared->system->findings().all()) {
      count += finding.severity == severity;
    }
    return count;
  };
}

}  // namespace

Quantity FindQuantity(const std::string& name, const RunView& view) {
  if (name.starts_with("objects.")) return FindInObjects(*view.prepared->system, 0, name.substr(8));
  if (name.starts_with("robots[")) {
    const std::string_view rest = std::string_view(name).substr(7);
    const std::string_view number = rest.substr(0, rest.find(']'));
    int64_t robot = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), robot);
    const bool is_number =
        error != std::errc::invalid_argument && end == number.data() + number.size();
    if (!is_number || !rest.substr(number.size()).starts_with("].")) {
      throw std::runtime_error(fmt::format("'{}': write robots[0].standing", name));
    }
    if (error != std::errc() || robot < 0 ||
        robot >= static_cast<int64_t>(view.prepared->robots.size())) {
      throw std::runtime_error(fmt::format("'{}': there is no robot {}", name, number));
    }
    return FindInRobot(view, static_cast<size_t>(robot), end + 2);
  }
  if (name == "messages") {
    return [](const RunView& now) -> Value {
      return static_cast<double>(now.prepared->system->message_count());
    };
  }
  if (!view.prepared->robots.empty() && IsOfFirstRobot(name)) return FindInRobot(view, 0, name);
  if (name == "findings.errors") return FindingCount(Severity::kError);
  if (name == "findings.warnings") return FindingCount(Severity::kWarning);
  Unknown("quantity", name,
          {"objects.NAME.state", "robots[0].standing", "messages", "findings.errors",
           "findings.warnings"});
}

std::vector<std::string> NumbersOf(const RunView& view) {
  std::vector<std::string> names;
  for (size_t i = 0; i < view.prepared->robots.size(); ++i) {
    const VirtualRobot& robot = *view.prepared->robots[i];
    const std::string begin = i == 0 ? "" : fmt::format("robots[{}].", i);
    for (const BaseQuantity& base : kOfBase) names.push_back(begin + base.name);
    names.push_back(begin + "battery_percent");
    for (const char* const group : {"command.", "measured.", "joint."}) {
      for (const JointModel& joint : robot.model().joints) {
        if (joint.sensor >= 0 || group != std::string("measured."))
          names.push_back(begin + group + joint.name);
      }
    }
    for (const Sensor& sensor : robot.model().sensors) {
      if (sensor.kind != SensorKind::kJoint)
        names.push_back(begin + "sensor." +
                        (sensor.short_name.empty() ? sensor.locator : sensor.short_name));
    }
    for (const WorldThing& thing : robot.body().MovableThings()) {
      for (const char* const axis : {"x_m", "y_m", "z_m"})
        names.push_back(fmt::format("{}thing.{}.{}", begin, thing.name, axis));
    }
  }
  return names;
}

std::vector<std::string> QuantitiesOf(const RunView& view) {
  std::vector<std::string> names = NumbersOf(view);
  for (size_t i = 0; i < view.prepared->robots.size(); ++i)
    names.push_back(i == 0 ? "standing" : fmt::format("robots[{}].standing", i));
  for (const auto& object : view.prepared->system->objects()) {
    for (const ObjectField& field : kOfObject)
      names.push_back(fmt::format(
          "{}objects.{}.{}", object->robot == 0 ? "" : fmt::format("robots[{}].", object->robot),
          object->name, field.name));
  }
  for (const char* const name : {"messages", "findings.errors", "findings.warnings"})
    names.push_back(name);
  return names;
}

std::vector<std::string> LongNamesOf(const RunView& view) {
  std::vector<std::string> names;
  for (const std::string& name : QuantitiesOf(view)) {
    if (IsOfFirstRobot(name) || name.starts_with("objects.")) names.push_back("robots[0]." + name);
  }
  return names;
}

SimulationView::SimulationView(Simulation* simulation) {
  prepared_.system = &simulation->system();
  prepared_.simulation = simulation;
  prepared_.robots = simulation->robots();
  for (const VirtualRobot* robot : prepared_.robots) standing_.emplace_back(robot->model());
  run_ = {&prepared_, &standing_, 0};
}

void SimulationView::Sample() {
  const int64_t now_us = prepared_.system->now_us();
  if (now_us / kFrameUs == frame_) return;
  frame_ = now_us / kFrameUs;
  for (size_t i = 0; i < standing_.size(); ++i)
    standing_[i].Sample(prepared_.robots[i]->body().state(), now_us);
}

}  // namespace openr_host
