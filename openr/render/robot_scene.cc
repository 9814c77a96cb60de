#include "openr/render/robot_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "openr/render/robot_shapes.h"
#include "runtime/base/assert.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
namespace {

struct ViewPlace {
  const char* name;
  View view;
  Eigen::Vector3d from;  // camera minus target, in m; x is forward
};

const ViewPlace* Places(size_t* count) {
  static const ViewPlace places[] = {
      {"side", View::kSide, {0.02, -1.05, 0.12}},   {"front", View::kFront, {1.05, 0.0, 0.14}},
      {"top", View::kTop, {-0.001, 0.0, 1.15}},     {"iso", View::kIso, {0.80, -0.62, 0.38}},
      {"follow", View::kFollow, {-0.95, 0.0, 0.5}},
  };
  *count = std::size(places);
  return places;
}

render::Camera CameraFor(const RobotLook& look, View view) {
  size_t count = 0;
  const ViewPlace* place = Places(&count);
  ASSERT(view != View::kCamera, "the robot's own camera draws its pictures itself");
  while (place->view != view) ++place;
  const Eigen::Vector3d forward = look.X_WB.linear().col(0);
  const double heading = std::atan2(forward.y(), forward.x());
  const Eigen::AngleAxisd turn(heading, Eigen::Vector3d::UnitZ());
  render::Camera camera;
  camera.target_W = look.X_WB.translation() + turn * Eigen::Vector3d(0.012, 0, 0);
  camera.target_W.z() = std::max(0.095, look.X_WB.translation().z() - 0.005);
  camera.p_W = camera.target_W + turn * place->from;
  if (view == View::kTop) camera.up = forward;
  camera.fov_rad = 0.37;
  return camera;
}

}  // namespace

bool ParseView(std::string_view name, View* view) {
  if (name == "camera") {
    *view = View::kCamera;
    return true;
  }
  size_t count = 0;
  const ViewPlace* const places = Places(&count);
  for (size_t i = 0; i < count; ++i) {
    if (name == places[i].name) {
      *view = places[i].view;
      return true;
    }
  }
  return false;
}

RobotLook LookOf(const VirtualRobot& robot) {
  RobotLook look;
  look.X_WB = robot.body().state().X_WB;
  look.X_WL = robot.body().BodyPoses();
  for (const LedDevice& led : robot.devices().leds) look.leds_on.push_back(led.intensity > 0);
  for (size_t i = 0; i < robot.devices().plungers.size(); ++i) {
    const Plunger& ear = robot.model().plungers[i];
    const bool on = robot.devices().plungers[i].state == ojoint3_STATE1;
    look.plungers_rad.push_back(on ? ear.on_rad : ear.off_rad);
  }
  return look;
}

render::Scene MakeRobotScene(const RobotModel& model, const RobotLook& look, const World& world,
                             View view) {
  render::Scene scene;
  for (const RobotShape& part : ShapesOfRobot(model)) {
    render::Shape shape = part.shape;
    const auto ear = static_cast<size_t>(part.ear), led = static_cast<size_t>(part.led);
    const bool has_angle = part.ear >= 0 && ear < look.plungers_rad.size();
    shape.X_WS = look.X_WL[static_cast<size_t>(part.body)] *
                 PlaceInPart(part, has_angle ? look.plungers_rad[ear] : 0);
    shape.glows = part.led >= 0 && led < look.leds_on.size() && look.leds_on[led];
    if (shape.glows) shape.colour = part.glow;
    scene.shapes.push_back(shape);
  }
  for (const render::Shape& shape : ShapesOfWorld(world)) scene.shapes.push_back(shape);
  scene.floor = FloorColour(world).value_or(scene.floor);
  scene.camera = CameraFor(look, view);
  return scene;
}

}  // namespace openr_host
