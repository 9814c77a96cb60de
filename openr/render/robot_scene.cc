#include "openr/render/robot_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace openr_host {
namespace {

using render::Colour;
using render::Shape;

constexpr Colour kSilver{0.80f, 0.81f, 0.83f};
constexpr Colour kGrey{0.44f, 0.45f, 0.48f};
constexpr Colour kBlack{0.13f, 0.13f, 0.15f};
constexpr Colour kWood{0.72f, 0.60f, 0.46f};

bool EndsWith(std::string_view text, std::string_view end) { return text.ends_with(end); }

// Returns the shape that pictures show for `part`: a box with rounded edges, instead of the plain
// box that physics uses.
Shape ShapeOfPart(const BodyPart& part, const Eigen::Isometry3d& X_WL) {
  Shape shape;
  shape.X_WS = X_WL * Eigen::Translation3d(part.centre_m);
  shape.size_m = part.size_m;
  shape.colour = kSilver;
  shape.radius_m = 0.35 * part.size_m.minCoeff();
  if (part.name == "body") shape.radius_m = 0.022;
  if (part.name == "head") shape.radius_m = 0.028;
  if (EndsWith(part.name, "_j2")) shape.radius_m = 0.0155;
  if (EndsWith(part.name, "_j3")) {
    shape.radius_m = 0.012;
    shape.colour = kGrey;
  }
  if (part.name.starts_with("neck") || part.name.starts_with("tail")) shape.colour = kGrey;
  if (part.name == "mouth") shape.colour = kBlack;
  shape.gloss = 0.45f;
  return shape;
}

Colour LightColour(const std::string& name) {
  if (name == "red") return {1.0f, 0.25f, 0.18f};
  if (name == "green") return {0.35f, 1.0f, 0.45f};
  if (name == "blue") return {0.35f, 0.60f, 1.0f};
  if (name == "orange") return {1.0f, 0.65f, 0.20f};
  return {1.0f, 1.0f, 0.85f};
}

// Places of the lights of the ERS-210, for joints at 0 degrees.  No document gives them, so they
// are estimated from photographs.
struct LightPlace {
  const char* name;
  const char* body;
  double x, y, z;
  double width, height;  // mm
};
constexpr LightPlace kLights[] = {
    {"Eye light (lower left)", "head", 146.8, 11, 101, 9, 3.5},
    {"Eye light (middle left)", "head", 146.8, 13, 107, 9, 3.5},
    {"Eye light (upper left)", "head", 146.8, 15, 113, 9, 3.5},
    {"Eye light (lower right)", "head", 146.8, -11, 101, 9, 3.5},
    {"Eye light (middle right)", "head", 146.8, -13, 107, 9, 3.5},
    {"Eye light (upper right)", "head", 146.8, -15, 113, 9, 3.5},
    {"Mode indicator", "head", 146.0, 0, 121, 5, 3},
    {"Tail light (blue)", "tail_tilt", -141.5, 4.5, 56.3, 6, 6},
    {"Tail light (orange)", "tail_tilt", -141.5, -4.5, 56.3, 6, 6},
};

void AddLights(const RobotModel& model, const RobotLook& look, std::vector<Shape>* shapes) {
  for (size_t i = 0; i < model.leds.size(); ++i) {
    const Led& led = model.leds[i];
    const auto* const place = std::find_if(std::begin(kLights), std::end(kLights),
                                           [&](const LightPlace& p) { return p.name == led.name; });
    if (place == std::end(kLights)) continue;
    const int body = model.FindBody(place->body);
    if (body < 0) continue;
    Shape shape;
    shape.X_WS = look.X_WL[static_cast<size_t>(body)] *
                 Eigen::Translation3d(place->x / 1000, place->y / 1000, place->z / 1000);
    shape.size_m = Eigen::Vector3d(6, place->width, place->height) / 1000;
    shape.radius_m = 0.0015;
    shape.glows = i < look.leds_on.size() && look.leds_on[i];
    shape.colour = LightColour(led.colour);
    if (!shape.glows) {
      shape.colour = {0.25f + 0.12f * shape.colour.r, 0.25f + 0.12f * shape.colour.g,
                      0.25f + 0.12f * shape.colour.b};
    }
    shapes->push_back(shape);
  }
}

// Adds the dark mask around the eyes, and the nose, which holds the camera.
void AddFace(const RobotModel& model, const RobotLook& look, std::vector<Shape>* shapes) {
  const int head = model.FindBody("head");
  if (head < 0 || !model.bodies[static_cast<size_t>(head)].has_box) return;
  const BodyPart& part = model.bodies[static_cast<size_t>(head)];
  const Eigen::Isometry3d& X_WL = look.X_WL[static_cast<size_t>(head)];
  const Eigen::Vector3d front = part.centre_m + Eigen::Vector3d(part.size_m.x() / 2, 0, 0);
  Shape mask;
  mask.X_WS = X_WL * Eigen::Translation3d(front + Eigen::Vector3d(-0.022, 0, 0.003));
  mask.size_m = {0.046, 0.069, 0.036};
  mask.radius_m = 0.017;
  mask.colour = kBlack;
  mask.gloss = 1.0f;
  shapes->push_back(mask);
  Shape nose;
  nose.X_WS = X_WL * Eigen::Translation3d(front + Eigen::Vector3d(-0.004, 0, -0.016));
  nose.size_m = {0.016, 0.022, 0.013};
  nose.radius_m = 0.006;
  nose.colour = kBlack;
  nose.gloss = 0.9f;
  shapes->push_back(nose);
}

// Adds the ears, the plungers of the model.  They have two positions: an ear that is off hangs
// down, and an ear that is on stands up.
void AddEars(const RobotModel& model, const RobotLook& look, std::vector<Shape>* shapes) {
  const int head = model.FindBody("head");
  for (size_t i = 0; head >= 0 && i < model.plungers.size(); ++i) {
    const Plunger& ear = model.plungers[i];
    const double side = ear.place_m.y() < 0 ? -1 : 1;
    const double angle = i < look.plungers_rad.size() ? look.plungers_rad[i] : 0;
    Shape shape;
    shape.size_m = {0.026, 0.009, 0.050};
    shape.radius_m = 0.0044;
    shape.colour = kBlack;
    shape.gloss = 0.6f;
    const Eigen::Vector3d root(ear.place_m.x() + 0.004, side * 0.0385, ear.place_m.z() + 0.004);
    shape.X_WS = look.X_WL[static_cast<size_t>(head)] * Eigen::Translation3d(root) *
                 Eigen::AngleAxisd(-0.35 - angle, Eigen::Vector3d::UnitY()) *
                 Eigen::Translation3d(0, 0, 0.020);
    shapes->push_back(shape);
  }
}

void AddPaws(const RobotModel& model, const RobotLook& look, std::vector<Shape>* shapes) {
  for (const Paw& paw : model.paws) {
    if (paw.body < 0) continue;
    Shape shape;
    shape.X_WS = look.X_WL[static_cast<size_t>(paw.body)] * Eigen::Translation3d(paw.centre_m);
    shape.size_m = Eigen::Vector3d::Constant(2 * paw.radius_m);
    shape.radius_m = paw.radius_m;
    shape.colour = kBlack;
    shape.gloss = 0.25f;
    shapes->push_back(shape);
  }
}

// Adds the hinges between the two parts of each leg, which look like knees.
void AddHinges(const RobotModel& model, const RobotLook& look, std::vector<Shape>* shapes) {
  for (const JointModel& joint : model.joints) {
    if (!EndsWith(joint.name, "_j3")) continue;
    Shape shape;
    shape.X_WS = look.X_WL[static_cast<size_t>(joint.child)] * Eigen::Translation3d(joint.anchor_m);
    shape.size_m = {0.026, 0.0345, 0.026};
    shape.radius_m = 0.0125;
    shape.colour = kBlack;
    shape.gloss = 0.5f;
    shapes->push_back(shape);
  }
}

void AddWorld(const World& world, std::vector<Shape>* shapes) {
  for (const WorldBox& box : world.boxes) {
    Shape shape;
    shape.X_WS = Eigen::Translation3d(box.centre_m) *
                 Eigen::AngleAxisd(box.yaw_rad, Eigen::Vector3d::UnitZ());
    shape.size_m = box.size_m;
    shape.radius_m = std::min(0.004, 0.2 * box.size_m.minCoeff());
    shape.colour = kWood;
    shape.gloss = 0.1f;
    shapes->push_back(shape);
  }
}

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

render::Scene MakeRobotScene(const RobotModel& model, const RobotLook& look, const World& world,
                             View view) {
  render::Scene scene;
  for (size_t i = 0; i < model.bodies.size(); ++i) {
    // Leaves out bodies of 2 mm or less.  These are the plates of 1 mm to which the model reduces
    // the joints J1 of the legs.  They lie inside the box of the trunk, so a picture does not need
    // them.
    if (model.bodies[i].has_box && model.bodies[i].size_m.minCoeff() > 0.002) {
      scene.shapes.push_back(ShapeOfPart(model.bodies[i], look.X_WL[i]));
    }
  }
  AddPaws(model, look, &scene.shapes);
  AddHinges(model, look, &scene.shapes);
  AddFace(model, look, &scene.shapes);
  AddLights(model, look, &scene.shapes);
  AddEars(model, look, &scene.shapes);
  AddWorld(world, &scene.shapes);
  scene.camera = CameraFor(look, view);
  return scene;
}

}  // namespace openr_host
