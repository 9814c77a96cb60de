#include "openr/render/robot_shapes.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "virtualrobot/worlds/height_grid.h"

namespace openr_host {
namespace {

using render::Colour;
using render::Shape;

constexpr Colour kSilver{0.80f, 0.81f, 0.83f};
constexpr Colour kGrey{0.44f, 0.45f, 0.48f};
constexpr Colour kBlack{0.13f, 0.13f, 0.15f};

Colour ColourFrom(const Eigen::Vector3d& rgb) {
  return {static_cast<float>(rgb.x()), static_cast<float>(rgb.y()), static_cast<float>(rgb.z())};
}

Eigen::Isometry3d At(const Eigen::Vector3d& place_m) {
  return Eigen::Isometry3d(Eigen::Translation3d(place_m));
}

// Adds the parts of the robot as boxes with rounded edges; physics uses plain boxes instead.
// Leaves out parts that are at most 2 mm thick: the plates of 1 mm by which the model represents
// the joints J1 of the legs.  They lie inside the box of the trunk, so a picture does not need
// them.
void AddParts(const RobotModel& model, std::vector<RobotShape>* shapes) {
  for (size_t i = 0; i < model.bodies.size(); ++i) {
    const BodyPart& part = model.bodies[i];
    if (!part.has_box || part.size_m.minCoeff() <= 0.002) continue;
    RobotShape added;
    added.body = static_cast<int>(i);
    Shape& shape = added.shape;
    shape.X_WS = At(part.centre_m);
    shape.size_m = part.size_m;
    shape.colour = kSilver;
    shape.radius_m = 0.35 * part.size_m.minCoeff();
    if (part.name == "body") shape.radius_m = 0.022;
    if (part.name == "head") shape.radius_m = 0.028;
    if (part.name.ends_with("_j2")) shape.radius_m = 0.0155;
    if (part.name.ends_with("_j3")) {
      shape.radius_m = 0.012;
      shape.colour = kGrey;
    }
    if (part.name.starts_with("neck") || part.name.starts_with("tail")) shape.colour = kGrey;
    if (part.name == "mouth") shape.colour = kBlack;
    shape.gloss = 0.45f;
    shapes->push_back(added);
  }
}

Colour LightColour(const std::string& name) {
  if (name == "red") return {1.0f, 0.25f, 0.18f};
  if (name == "green") return {0.35f, 1.0f, 0.45f};
  if (name == "blue") return {0.35f, 0.60f, 1.0f};
  if (name == "orange") return {1.0f, 0.65f, 0.20f};
  return {1.0f, 1.0f, 0.85f};
}

// The place of a light when all joints are at 0 degrees.  One table serves all three robot models,
// because lights of different models have different names.  No document gives these places: the
// places on the ERS-210 are estimated from photographs, and the places on the other models are
// chosen by the names of the lights.
struct LightPlace {
  const char* name;
  const char* body;
  double x, y, z;
  double width, height;  // size of the light, in mm
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
    // The lights of the ERS-7.
    {"Face light 1", "head", 144, 6, 100, 6, 4},
    {"Face light 2", "head", 144, -6, 100, 6, 4},
    {"Face light 3", "head", 144, 14, 103, 6, 4},
    {"Face light 4", "head", 144, -14, 103, 6, 4},
    {"Face light 5", "head", 144, 0, 107, 6, 4},
    {"Face light 6", "head", 144, 22, 107, 6, 4},
    {"Face light 7", "head", 144, -22, 107, 6, 4},
    {"Face light 8", "head", 144, 8, 119, 6, 4},
    {"Face light 9", "head", 144, -8, 119, 6, 4},
    {"Face light 10", "head", 144, 22, 119, 6, 4},
    {"Face light 11", "head", 144, -22, 119, 6, 4},
    {"Face light 12", "head", 144, 0, 125, 8, 4},
    {"Face light 13", "head", 144, 15, 113, 9, 5},
    {"Face light 14", "head", 144, -15, 113, 9, 5},
    {"Head light (color)", "head", 120, 4, 149, 6, 3},
    {"Head light (white)", "head", 120, -4, 149, 6, 3},
    {"Mode indicator (red)", "head", 62, 7, 149, 5, 3},
    {"Mode indicator (green)", "head", 62, 0, 149, 5, 3},
    {"Mode indicator (blue)", "head", 62, -7, 149, 5, 3},
    {"Wireless light", "body", -70, 0, 46, 6, 3},
    {"Back light (front, color)", "body", 26.5, 6, 48, 8, 3},
    {"Back light (front, white)", "body", 26.5, -6, 48, 8, 3},
    {"Back light (middle, color)", "body", -7.5, 6, 48, 8, 3},
    {"Back light (middle, white)", "body", -7.5, -6, 48, 8, 3},
    {"Back light (rear, color)", "body", -41.5, 6, 48, 8, 3},
    {"Back light (rear, white)", "body", -41.5, -6, 48, 8, 3},
    // The lights of the ERS-220.
    {"Face side light (front left)", "head", 130, 34, 109, 3, 4},
    {"Face side light (center left)", "head", 118, 34, 109, 3, 4},
    {"Face side light (back left)", "head", 106, 34, 109, 3, 4},
    {"Face side light (front right)", "head", 130, -34, 109, 3, 4},
    {"Face side light (center right)", "head", 118, -34, 109, 3, 4},
    {"Face side light (back right)", "head", 106, -34, 109, 3, 4},
    {"Head indicator", "head", 75, 0, 139, 6, 3},
    {"Face front light A", "head", 146.8, 13, 111, 8, 4},
    {"Face front light B", "head", 146.8, 0, 111, 8, 4},
    {"Face front light C", "head", 146.8, -13, 111, 8, 4},
    {"Retractable head light", "head", 100, 0, 140, 10, 6},
    {"Back multi-indicator (first from the left)", "body", -60, 20, 54, 5, 3},
    {"Back multi-indicator (second from the left)", "body", -60, 12, 54, 5, 3},
    {"Back multi-indicator (third from the left)", "body", -60, 4, 54, 5, 3},
    {"Back multi-indicator (third from the right)", "body", -60, -4, 54, 5, 3},
    {"Back multi-indicator (second from the right)", "body", -60, -12, 54, 5, 3},
    {"Back multi-indicator (first from the right)", "body", -60, -20, 54, 5, 3},
    {"Tail light (center)", "body", -127, 0, 38, 6, 6},
    {"Tail light (right)", "body", -127, -9, 38, 6, 6},
    {"Tail light (left)", "body", -127, 9, 38, 6, 6},
};

void AddLights(const RobotModel& model, std::vector<RobotShape>* shapes) {
  for (size_t i = 0; i < model.leds.size(); ++i) {
    const Led& led = model.leds[i];
    const auto* const place = std::find_if(std::begin(kLights), std::end(kLights),
                                           [&](const LightPlace& p) { return p.name == led.name; });
    if (place == std::end(kLights)) continue;
    RobotShape added;
    added.body = model.FindBody(place->body);
    if (added.body < 0) continue;
    added.led = static_cast<int>(i);
    added.glow = LightColour(led.colour);
    added.glow_b = led.colour_b.empty() ? added.glow : LightColour(led.colour_b);
    Shape& shape = added.shape;
    shape.X_WS = At(Eigen::Vector3d(place->x, place->y, place->z) / 1000);
    shape.size_m = Eigen::Vector3d(6, place->width, place->height) / 1000;
    shape.radius_m = 0.0015;
    shape.colour = {0.25f + 0.12f * added.glow.r, 0.25f + 0.12f * added.glow.g,
                    0.25f + 0.12f * added.glow.b};
    shapes->push_back(added);
  }
}

// Adds the dark mask around the eyes, and the nose, which holds the camera.  The mask of the ERS-7
// is a plate over the whole face, with its face lights.
void AddFace(const RobotModel& model, std::vector<RobotShape>* shapes) {
  const int head = model.FindBody("head");
  if (head < 0 || !model.bodies[static_cast<size_t>(head)].has_box) return;
  const BodyPart& part = model.bodies[static_cast<size_t>(head)];
  const Eigen::Vector3d front = part.centre_m + Eigen::Vector3d(part.size_m.x() / 2, 0, 0);
  RobotShape mask;
  mask.body = head;
  mask.shape.X_WS = At(front + Eigen::Vector3d(-0.022, 0, 0.003));
  const bool is_plate = std::any_of(model.leds.begin(), model.leds.end(), [](const Led& led) {
    return led.name.starts_with("Face light");
  });
  mask.shape.size_m = {0.046, 0.069, is_plate ? 0.054 : 0.036};
  mask.shape.radius_m = 0.017;
  mask.shape.colour = kBlack;
  mask.shape.gloss = 1.0f;
  shapes->push_back(mask);
  RobotShape nose;
  nose.body = head;
  nose.shape.X_WS = At(front + Eigen::Vector3d(-0.004, 0, -0.016));
  nose.shape.size_m = {0.016, 0.022, 0.013};
  nose.shape.radius_m = 0.006;
  nose.shape.colour = kBlack;
  nose.shape.gloss = 0.9f;
  shapes->push_back(nose);
}

// Adds the end piece behind the trunk of the ERS-220, the only robot without tail joints.  The end
// piece carries the tail lights, and is a part of the robot's overall length of 276 mm.
void AddEndPiece(const RobotModel& model, std::vector<RobotShape>* shapes) {
  const int body = model.FindBody("body");
  if (body < 0 || model.FindBody("tail_tilt") >= 0) return;
  RobotShape added;
  added.body = body;
  added.shape.X_WS = At({-0.106, 0, 0.038});
  added.shape.size_m = {0.045, 0.034, 0.020};
  added.shape.radius_m = 0.008;
  added.shape.colour = kGrey;
  added.shape.gloss = 0.45f;
  shapes->push_back(added);
}

// Angle by which an ear leans back when the ear's angle in the model is 0.
constexpr double kEarLean_rad = -0.35;

// Adds the ears, which are the plungers of the model.  An ear has two positions: when it is off it
// hangs down, and when it is on it stands up.
void AddEars(const RobotModel& model, std::vector<RobotShape>* shapes) {
  const int head = model.FindBody("head");
  for (size_t i = 0; head >= 0 && i < model.plungers.size(); ++i) {
    const Plunger& ear = model.plungers[i];
    const double side = ear.place_m.y() < 0 ? -1 : 1;
    RobotShape added;
    added.body = head;
    added.ear = static_cast<int>(i);
    const double half_width_m = model.bodies[static_cast<size_t>(head)].size_m.y() / 2;
    added.pivot = {ear.place_m.x() + 0.004, side * (half_width_m + 0.0045),
                   ear.place_m.z() + 0.004};
    Shape& shape = added.shape;
    shape.X_WS = At(added.pivot) * Eigen::AngleAxisd(kEarLean_rad, Eigen::Vector3d::UnitY()) *
                 Eigen::Translation3d(0, 0, 0.020);
    shape.size_m = {0.026, 0.009, 0.050};
    shape.radius_m = 0.0044;
    shape.colour = kBlack;
    shape.gloss = 0.6f;
    shapes->push_back(added);
  }
}

void AddPaws(const RobotModel& model, std::vector<RobotShape>* shapes) {
  for (const Paw& paw : model.paws) {
    if (paw.body < 0) continue;
    RobotShape added;
    added.body = paw.body;
    if (paw.sensor >= 0) added.touch = model.sensors[static_cast<size_t>(paw.sensor)].short_name;
    added.shape.X_WS = At(paw.centre_m);
    added.shape.size_m = Eigen::Vector3d::Constant(2 * paw.radius_m);
    added.shape.radius_m = paw.radius_m;
    added.shape.colour = kBlack;
    added.shape.gloss = 0.25f;
    shapes->push_back(added);
  }
}

// Adds the hinges between the two parts of each leg, which look like knees.
void AddHinges(const RobotModel& model, std::vector<RobotShape>* shapes) {
  for (const JointModel& joint : model.joints) {
    if (!joint.name.ends_with("_j3")) continue;
    RobotShape added;
    added.body = joint.child;
    added.shape.X_WS = At(joint.anchor_m);
    added.shape.size_m = {0.026, 0.0345, 0.026};
    added.shape.radius_m = 0.0125;
    added.shape.colour = kBlack;
    added.shape.gloss = 0.5f;
    shapes->push_back(added);
  }
}

// The place of a touch sensor on the surface of the box of a part.  `x`, `y` and `z` count from the
// centre of the box, as fractions of its edges.  No document gives the places, so they are
// estimated from photographs.
struct TouchPlace {
  const char* sensor;
  const char* body;
  double x, y, z;
  double length, width;  // size of the sensor, in mm
};
constexpr TouchPlace kTouchPlaces[] = {
    {"head_back", "head", -0.22, 0, 0.5, 22, 34}, {"head_front", "head", 0.10, 0, 0.5, 22, 34},
    {"head_1", "head", -0.22, 0, 0.5, 22, 34},    {"head_2", "head", 0.10, 0, 0.5, 22, 34},
    {"head", "head", -0.05, 0, 0.5, 34, 34},      {"chin", "mouth", 0.15, 0, -0.5, 20, 18},
    {"back", "body", -0.05, 0, 0.5, 34, 24},      {"back_front", "body", 0.20, 0, 0.5, 26, 30},
    {"back_middle", "body", 0.0, 0, 0.5, 26, 30}, {"back_rear", "body", -0.20, 0, 0.5, 26, 30},
};

void AddTouchPads(const RobotModel& model, std::vector<RobotShape>* shapes) {
  for (const TouchPlace& place : kTouchPlaces) {
    const auto has_name = [&](const Sensor& sensor) { return sensor.short_name == place.sensor; };
    RobotShape added;
    added.body = model.FindBody(place.body);
    if (added.body < 0 || std::none_of(model.sensors.begin(), model.sensors.end(), has_name))
      continue;
    const BodyPart& part = model.bodies[static_cast<size_t>(added.body)];
    if (!part.has_box) continue;
    const Eigen::Vector3d fraction(place.x, place.y, place.z);
    added.touch = place.sensor;
    added.shape.X_WS = At(part.centre_m + fraction.cwiseProduct(part.size_m));
    added.shape.size_m = Eigen::Vector3d(place.length, place.width, 4) / 1000;
    added.shape.radius_m = 0.0019;
    added.shape.colour = kGrey;
    shapes->push_back(added);
  }
}

}  // namespace

std::vector<RobotShape> ShapesOfRobot(const RobotModel& model) {
  std::vector<RobotShape> shapes;
  AddParts(model, &shapes);
  AddPaws(model, &shapes);
  AddHinges(model, &shapes);
  AddFace(model, &shapes);
  AddEndPiece(model, &shapes);
  AddTouchPads(model, &shapes);
  AddLights(model, &shapes);
  AddEars(model, &shapes);
  return shapes;
}

Eigen::Isometry3d PlaceInPart(const RobotShape& shape, double angle_rad) {
  if (shape.ear < 0) return shape.shape.X_WS;
  return At(shape.pivot) * Eigen::AngleAxisd(-angle_rad, Eigen::Vector3d::UnitY()) *
         At(-shape.pivot) * shape.shape.X_WS;
}

std::optional<Colour> FloorColour(const World& world) {
  if (world.floor_colour == World().floor_colour) return std::nullopt;
  return ColourFrom(world.floor_colour);
}

std::vector<Shape> ShapesOfWorld(const World& world) {
  // Largest height above the floor at which coloured areas of the floor are drawn, as flat plates.
  // The height is so small that nobody sees a step in the picture.
  constexpr double kPaintTop_m = 0.004;
  const auto is_paint = [](const WorldThing& thing) { return !thing.is_solid; };
  const auto paints = std::count_if(world.things.begin(), world.things.end(), is_paint);
  double paint_height_m = 0;
  std::vector<Shape> shapes;
  for (const WorldThing& thing : world.things) {
    Shape shape;
    shape.X_WS.linear() = thing.R_WT;
    shape.X_WS.translation() = thing.centre_m;
    shape.size_m = thing.size_m;
    const double shortest_m = thing.size_m.minCoeff();
    // A sphere is drawn as a box.  Its edges get a radius of half their length, so the box becomes
    // a ball.
    shape.radius_m =
        thing.shape == ThingShape::kSphere ? shortest_m / 2 : std::min(0.004, 0.2 * shortest_m);
    shape.is_cylinder = thing.shape == ThingShape::kCylinder;
    if (thing.shape == ThingShape::kHeightField) {
      for (const Triangle& triangle : OutsideOf(thing)) {
        for (const Eigen::Vector3d& corner : triangle)
          shape.triangles.push_back(corner.cast<float>());
      }
    }
    shape.colour = ColourFrom(thing.colour);
    shape.gloss = 0.1f;
    if (is_paint(thing)) {
      // Each painted area of the floor lies a little higher than the area before it, and so covers
      // it.
      paint_height_m += std::min(0.0003, kPaintTop_m / static_cast<double>(paints));
      shape.size_m.z() = paint_height_m;
      shape.X_WS.translation().z() = paint_height_m / 2;
      shape.radius_m = 0;
      shape.gloss = 0;
    }
    shapes.push_back(shape);
  }
  return shapes;
}

}  // namespace openr_host
