#include "openr/explore/quantity.h"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>

#include "runtime/base/spelling.h"
#include "virtualrobot/det_math.h"
#include "virtualrobot/kinematics.h"

namespace openr_host {
namespace {

constexpr size_t kNone = std::string::npos;

[[noreturn]] void Unknown(const std::string& what, const std::string& name,
                          const std::vector<std::string>& known) {
  throw std::runtime_error(fmt::format("no {} '{}'{}", what, name, DidYouMean(name, known)));
}

Quantity OfObject(const Object* object, const std::string& field) {
  if (field == "state") return [object](const RunView&) -> Value { return object->state; };
  if (field == "messages") {
    return [object](const RunView&) -> Value { return static_cast<double>(object->message_count); };
  }
  if (field == "dropped") {
    return [object](const RunView&) -> Value { return static_cast<double>(object->dropped_count); };
  }
  if (field == "queue_max") {
    return [object](const RunView&) -> Value { return static_cast<double>(object->waiting_max); };
  }
  Unknown("field of an object", field, {"state", "messages", "dropped", "queue_max"});
}

// Returns the quantity `name`.  `name` has the name of an object and of a field of the object, such
// as "JointMover.state".
Quantity FindInObjects(const System& system, int robot, const std::string& name) {
  const size_t dot = name.rfind('.');
  if (dot == kNone)
    throw std::runtime_error(fmt::format("'{}' has no field; write objects.NAME.state", name));
  const std::string object_name = name.substr(0, dot);
  const Object* const object = system.FindObject(robot, object_name);
  if (object != nullptr) return OfObject(object, name.substr(dot + 1));
  std::vector<std::string> known;
  for (const auto& each : system.objects()) {
    if (each->robot == robot) known.push_back(each->name);
  }
  Unknown(fmt::format("object of robot {}", robot), object_name, known);
}

// Returns the quantity for the angle of a joint, in degrees.  `name` is the joint's name in the
// model, such as "LF_j1", or its locator, which is its name in OPEN-R.
Quantity FindJoint(const RobotModel& model, size_t robot, const std::string& name) {
  int joint = model.FindJoint(name);
  if (joint < 0) joint = model.FindJointByLocator(name);
  if (joint < 0) {
    std::vector<std::string> known;
    for (const JointModel& each : model.joints) known.push_back(each.name);
    Unknown("joint", name, known);
  }
  return [robot, index = static_cast<size_t>(joint)](const RunView& view) -> Value {
    return Degrees(view.prepared->robots[robot]->body().state().joints[index].angle_rad);
  };
}

// Returns the quantity for the value of a sensor, in OPEN-R's unit.  `locator` is the name of the
// sensor in OPEN-R.
Quantity FindSensor(const RobotModel& model, size_t robot, const std::string& locator) {
  const int sensor = model.FindSensorByLocator(locator);
  if (sensor < 0) {
    std::vector<std::string> known;
    for (const Sensor& each : model.sensors) known.push_back(each.locator);
    Unknown("sensor", locator, known);
  }
  return [robot, sensor](const RunView& view) -> Value {
    return static_cast<double>(view.prepared->robots[robot]->sensor(sensor).value);
  };
}

Quantity OfBase(size_t robot, double (*function)(const BodyState&)) {
  return [robot, function](const RunView& view) -> Value {
    return function(view.prepared->robots[robot]->body().state());
  };
}

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
  if (name == "standing") {
    return [robot](const RunView& now) -> Value {
      return std::string((*now.standing)[robot].standing() ? "true" : "false");
    };
  }
  if (name == "height_mm") {
    return OfBase(robot, [](const BodyState& state) { return state.X_WB.translation().z() * 1e3; });
  }
  if (name == "x_m")
    return OfBase(robot, [](const BodyState& state) { return state.X_WB.translation().x(); });
  if (name == "y_m")
    return OfBase(robot, [](const BodyState& state) { return state.X_WB.translation().y(); });
  if (name == "yaw_deg") {
    return OfBase(robot,
                  [](const BodyState& state) { return Degrees(RpyOf(state.X_WB.linear()).z()); });
  }
  if (name == "roll_deg") {
    return OfBase(robot,
                  [](const BodyState& state) { return Degrees(RpyOf(state.X_WB.linear()).x()); });
  }
  if (name == "pitch_deg") {
    return OfBase(robot,
                  [](const BodyState& state) { return Degrees(RpyOf(state.X_WB.linear()).y()); });
  }
  Unknown("quantity of a robot", name,
          {"standing", "x_m", "y_m", "height_mm", "roll_deg", "pitch_deg", "yaw_deg", "joint.NAME",
           "sensor.LOCATOR", "thing.NAME.x_m", "objects.NAME.state"});
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
    char* end = nullptr;
    const unsigned long robot = std::strtoul(name.c_str() + 7, &end, 10);
    if (std::string_view(end).substr(0, 2) != "].") {
      throw std::runtime_error(fmt::format("'{}': write robots[0].standing", name));
    }
    if (robot >= view.prepared->robots.size()) {
      throw std::runtime_error(fmt::format("'{}': there is no robot {}", name, robot));
    }
    return FindInRobot(view, robot, end + 2);
  }
  if (name == "messages") {
    return [](const RunView& now) -> Value {
      return static_cast<double>(now.prepared->system->message_count());
    };
  }
  if (name == "findings.errors") return FindingCount(Severity::kError);
  if (name == "findings.warnings") return FindingCount(Severity::kWarning);
  Unknown("quantity", name,
          {"objects.NAME.state", "robots[0].standing", "messages", "findings.errors",
           "findings.warnings"});
}

}  // namespace openr_host
