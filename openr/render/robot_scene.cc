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
  // Vector from the target (the point at which the camera looks) to the camera, in m; x is the
  // robot's forward direction.
  Eigen::Vector3d from;
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
  // This camera looks down, so z cannot be its upward direction.
  if (view == View::kTop) camera.up = forward;
  camera.fov_rad = 0.37;
  return camera;
}

// Returns a camera that sees all robots and things.  It looks from the side of the world where y is
// negative.
render::Camera CameraOverWorld(const std::vector<RobotLook>& looks, const World& world) {
  // The picture must show kRobot_m around the origin of each robot, and all things within
  // kReachMax_m of the point in the middle between the robots.  Things that are further away are
  // ignored, because in a picture that shows them the robots would be too small.
  constexpr double kRobot_m = 0.25, kReachMax_m = 6;
  Eigen::AlignedBox2d seen;
  for (const RobotLook& look : looks) {
    const Eigen::Vector2d place = look.X_WB.translation().head<2>();
    seen.extend(Eigen::Vector2d(place.array() - kRobot_m));
    seen.extend(Eigen::Vector2d(place.array() + kRobot_m));
  }
  const Eigen::Vector2d middle = seen.center();
  for (const WorldThing& thing : world.things) {
    const Eigen::Vector2d place = thing.centre_m.head<2>();
    if ((place - middle).norm() < kReachMax_m) seen.extend(place);
  }
  render::Camera camera;
  camera.fov_rad = 0.5;
  camera.target_W = Eigen::Vector3d(seen.center().x(), seen.center().y(), 0);
  // Multiplies the extent of the robots and things along x by 9/16, because a picture of 16:9 shows
  // more of the width than of the height.
  const double reach_m = std::max(seen.sizes().x() * 9 / 16, seen.sizes().y()) / 2;
  camera.shadow_reach_m = seen.sizes().maxCoeff() / 2 + kRobot_m;
  camera.p_W =
      camera.target_W + Eigen::Vector3d(0, -0.75, 0.8).normalized() * (1.25 * reach_m / 0.25 + 0.2);
  return camera;
}

}  // namespace

bool ParseView(std::string_view name, View* view) {
  if (name == "camera" || name == "world") {
    *view = name == "camera" ? View::kCamera : View::kWorld;
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
  for (size_t i = 0; i < robot.devices().leds.size(); ++i) {
    const LedDevice& led = robot.devices().leds[i];
    const double full = robot.model().leds[i].type == "LED3" ? 255 : 1;
    look.leds.push_back(std::clamp(led.intensity / full, 0.0, 1.0));
    if (robot.devices().OnFace(static_cast<int>(i)))
      look.is_face_in_mode_b = led.mode == oled3_MODE_B;
  }
  for (size_t i = 0; i < robot.devices().plungers.size(); ++i) {
    const Plunger& ear = robot.model().plungers[i];
    const bool on = robot.devices().plungers[i].state == ojoint3_STATE1;
    look.plungers_rad.push_back(on ? ear.on_rad : ear.off_rad);
  }
  return look;
}

namespace {

// Returns the colour between `dark` and `bright`: `share` 0 gives `dark`, `share` 1 gives `bright`.
render::Colour Between(const render::Colour& dark, const render::Colour& bright, float share) {
  const auto mix = [share](float a, float b) { return a + (b - a) * share; };
  return {mix(dark.r, bright.r), mix(dark.g, bright.g), mix(dark.b, bright.b)};
}

void AddRobot(const RobotModel& model, const RobotLook& look, render::Scene* scene) {
  for (const RobotShape& part : ShapesOfRobot(model)) {
    render::Shape shape = part.shape;
    const auto ear = static_cast<size_t>(part.ear), led = static_cast<size_t>(part.led);
    const bool has_angle = part.ear >= 0 && ear < look.plungers_rad.size();
    shape.X_WS = look.X_WL[static_cast<size_t>(part.body)] *
                 PlaceInPart(part, has_angle ? look.plungers_rad[ear] : 0);
    shape.glows = part.led >= 0 && led < look.leds.size() && look.leds[led] > 0;
    if (shape.glows) {
      const render::Colour& glow = look.is_face_in_mode_b ? part.glow_b : part.glow;
      shape.colour = Between(shape.colour, glow, static_cast<float>(look.leds[led]));
    }
    scene->shapes.push_back(shape);
  }
}

}  // namespace

render::Scene MakeRobotScene(const RobotModel& model, const std::vector<RobotLook>& looks,
                             const World& world, View view) {
  ASSERT(view != View::kCamera);
  render::Scene scene;
  for (const RobotLook& look : looks) AddRobot(model, look, &scene);
  for (const render::Shape& shape : ShapesOfWorld(world)) scene.shapes.push_back(shape);
  scene.floor = FloorColour(world).value_or(scene.floor);
  scene.camera =
      view == View::kWorld ? CameraOverWorld(looks, world) : CameraFor(looks.front(), view);
  return scene;
}

}  // namespace openr_host
