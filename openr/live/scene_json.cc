#include "openr/live/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "openr/render/robot_scene.h"
#include "openr/render/robot_shapes.h"
#include "runtime/core/system.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// Returns `value` rounded to four decimals, so that the lines with these values are short.
double Rounded(double value) { return std::round(value * 1e4) / 1e4; }

Json JsonOf(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

// Returns a pose as seven numbers: x, y and z in metres, then w, x, y and z of the quaternion.
Json JsonOf(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d p = pose.translation();
  const Eigen::Quaterniond q(pose.linear());
  return Json::array({p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()});
}

std::string ColourText(const render::Colour& colour) {
  const auto level = [](float part) {
    return static_cast<int>(std::lround(std::clamp(part, 0.0f, 1.0f) * 255));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", level(colour.r), level(colour.g), level(colour.b));
}

Json JsonOf(const render::Shape& shape) {
  Json json = {{"size", JsonOf(shape.size_m)},
               {"radius", shape.radius_m},
               {"pose", JsonOf(shape.X_WS)},
               {"colour", ColourText(shape.colour)},
               {"gloss", shape.gloss}};
  if (shape.is_cylinder) json["cylinder"] = true;
  for (const Eigen::Vector3f& corner : shape.triangles) {
    for (const float part : corner) json["triangles"].push_back(Rounded(static_cast<double>(part)));
  }
  return json;
}

Json LinksJson(const RobotModel& model) {
  Json links = Json::array();
  for (const BodyPart& part : model.bodies)
    links.push_back({{"name", part.name}, {"shapes", Json::array()}});
  for (const RobotShape& part : ShapesOfRobot(model)) {
    Json shape = JsonOf(part.shape);
    if (part.led >= 0) {
      shape["led"] = part.led;
      shape["glow"] = ColourText(part.glow);
      shape["glow_b"] = ColourText(part.glow_b);
    }
    if (part.ear >= 0) {
      shape["ear"] = part.ear;
      shape["pivot"] = JsonOf(part.pivot);
      shape["axis"] = JsonOf(Eigen::Vector3d(0, -1, 0));
    }
    if (!part.touch.empty()) shape["touch"] = part.touch;
    links[static_cast<size_t>(part.body)]["shapes"].push_back(shape);
  }
  return links;
}

Json JointsJson(const RobotModel& model) {
  Json joints = Json::array();
  for (const JointModel& joint : model.joints) {
    const std::string title =
        joint.sensor < 0 ? joint.name : model.sensors[static_cast<size_t>(joint.sensor)].name;
    joints.push_back({{"name", joint.name},
                      {"title", title},
                      {"locator", joint.locator},
                      {"min_deg", Degrees(joint.soft_rad.min)},
                      {"max_deg", Degrees(joint.soft_rad.max)},
                      {"max_speed", Degrees(joint.speed_rad_s.max)},
                      {"max_accel", Degrees(model.accel_max_rad_s2)},
                      {"accel", Degrees(model.accel_default_rad_s2)}});
  }
  return joints;
}

const char* UnitOf(SensorKind kind) {
  switch (kind) {
    case SensorKind::kSwitch:
      return "switch";
    case SensorKind::kForce:
      return "force";
    case SensorKind::kDistance:
      return "length";
    case SensorKind::kTemperature:
      return "temperature";
    case SensorKind::kAcceleration:
      return "acceleration";
    default:
      return "counts";
  }
}

// Returns whether the input "press" can press `sensor`.
bool CanBePressed(const Sensor& sensor) {
  return sensor.kind == SensorKind::kSwitch || sensor.kind == SensorKind::kForce ||
         sensor.kind == SensorKind::kRaw;
}

Json SensorsJson(const RobotModel& model) {
  Json sensors = Json::array();
  for (const Sensor& sensor : model.sensors) {
    if (sensor.joint >= 0) continue;
    Json each = {{"name", sensor.short_name},     {"long_name", sensor.name},
                 {"locator", sensor.locator},     {"unit", UnitOf(sensor.kind)},
                 {"press", CanBePressed(sensor)}, {"settable", true}};
    if (sensor.has_range) {
      each["min"] = sensor.min;
      each["max"] = sensor.max;
    }
    sensors.push_back(std::move(each));
  }
  return sensors;
}

Json RobotJson(const RobotModel& model) {
  Json leds = Json::array(), ears = Json::array();
  for (const Led& led : model.leds) leds.push_back({{"name", led.name}, {"locator", led.locator}});
  for (const Plunger& ear : model.plungers)
    ears.push_back({{"name", ear.name}, {"locator", ear.locator}});
  return {{"links", LinksJson(model)},
          {"joints", JointsJson(model)},
          {"leds", leds},
          {"ears", ears},
          {"sensors", SensorsJson(model)}};
}

double TimeOf(Simulation* simulation) {
  return static_cast<double>(simulation->system().now_us()) / 1e6;
}

void AppendPose(const Eigen::Isometry3d& pose, std::string* text) {
  const Eigen::Vector3d p = pose.translation();
  const Eigen::Quaterniond q(pose.linear());
  fmt::format_to(std::back_inserter(*text), "[{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f}]",
                 p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z());
}

// Returns the present values of the joints, sensors and other parts of `robot`.  `number` is the
// number of the robot in `system`.
Json ValuesOf(System* system, int number, VirtualRobot* robot) {
  const RobotModel& model = robot->model();
  const bool is_off = system->robot(number).powered_off;
  const OffRobots& off_robots = system->robot_table().off_robots();
  Json joints = Json::array(), gains = Json::array(), sensors = Json::array();
  for (size_t i = 0; i < model.joints.size(); ++i) {
    const JointDevice& joint = robot->devices().joints[i];
    const double target = Rounded(Degrees(joint.target_urad * 1e-6));
    const double measured = Rounded(Degrees(robot->body().state().joints[i].angle_rad));
    joints.push_back(joint.commanded ? Json::array({target, measured})
                                     : Json::array({nullptr, measured}));
    gains.push_back(
        robot->devices().MovesJoint(static_cast<int>(i), robot->power().motor_power()) ? 1 : 0);
  }
  for (size_t i = 0; i < model.sensors.size(); ++i) {
    if (model.sensors[i].joint >= 0) continue;
    sensors.push_back(is_off ? Json() : Json(robot->sensor(static_cast<int>(i)).value));
  }
  const OPowerStatus status = robot->power().Status();
  const Object* const mover = system->FindObject(number, "JointMover");
  return {{"state", is_off             ? "off"
                    : mover == nullptr ? ""
                                       : mover->statistics().state()},
          {"boots_at_s", off_robots.Contains(number)
                             ? Json(static_cast<double>(off_robots.BootUs(number)) / 1e6)
                             : Json()},
          {"joints", joints},
          {"gains", gains},
          {"sensors", sensors},
          {"battery",
           {{"percent", robot->power().remaining_percent()},
            {"charging", robot->power().charging()},
            {"celsius", Rounded(status.temperature / 10.0 - 273.15)}}},
          {"motors", robot->power().motor_power()},
          {"pause_button", robot->power().pause()},
          {"held", robot->parts().hands.is_holding()},
          {"faults", robot->parts().faults.Present()}};
}

}  // namespace

Json SceneJson(const Simulation& simulation) {
  Json robots = Json::array(), shapes = Json::array();
  for (size_t i = 0; i < simulation.robots().size(); ++i)
    robots.push_back(RobotJson(simulation.model()));
  for (const render::Shape& shape : ShapesOfWorld(simulation.world()))
    shapes.push_back(JsonOf(shape));
  // Numbers the things of the world that can move, in their order.  The number of a thing is the
  // index of its pose in the event "pose".
  int movable = 0;
  const std::vector<WorldThing>& things = simulation.world().things;
  for (size_t i = 0; i < things.size(); ++i) {
    if (things[i].mass_kg > 0) shapes[i]["thing"] = movable++;
  }
  Json world = {{"shapes", shapes}};
  if (const auto floor = FloorColour(simulation.world())) world["floor"] = ColourText(*floor);
  const bool is_physical =
      !simulation.robots().empty() && simulation.robots().front()->body().IsPhysical();
  return {{"model", simulation.model().name},       {"body", is_physical ? "ode" : "ideal"},
          {"grid_m", render::Scene().floor_grid_m}, {"world", world},
          {"together", simulation.is_together()},   {"robots", robots}};
}

std::string PoseText(Simulation* simulation) {
  std::string text = fmt::format("\"time_s\":{:.6f},\"robots\":[", TimeOf(simulation));
  const char* between_robots = "";
  for (const VirtualRobot* const robot : simulation->robots()) {
    const RobotLook look = LookOf(*robot);
    text += std::exchange(between_robots, ",");
    text += "{\"links\":[";
    const char* between = "";
    for (const Eigen::Isometry3d& X_WL : look.X_WL) {
      text += std::exchange(between, ",");
      AppendPose(X_WL, &text);
    }
    fmt::format_to(std::back_inserter(text), "],\"leds\":[{:.3g}],{}\"ears\":[{:.4f}],\"things\":[",
                   fmt::join(look.leds, ","), look.is_face_in_mode_b ? "\"mode_b\":true," : "",
                   fmt::join(look.plungers_rad, ","));
    between = "";
    for (const WorldThing& thing : robot->body().MovableThings()) {
      text += std::exchange(between, ",");
      Eigen::Isometry3d X_WT(thing.R_WT);
      X_WT.pretranslate(thing.centre_m);
      AppendPose(X_WT, &text);
    }
    text += "]}";
  }
  return text + "]";
}

Json ValuesJson(Simulation* simulation) {
  Json robots = Json::array();
  int number = 0;
  for (VirtualRobot* const robot : simulation->robots())
    robots.push_back(ValuesOf(&simulation->system(), number++, robot));
  return {{"time_s", TimeOf(simulation)}, {"robots", robots}};
}

}  // namespace openr_host
