#include "virtualrobot/camera/rendered_world.h"

#include <algorithm>
#include <array>
#include <utility>

#include "runtime/base/assert.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/body/body.h"
#include "virtualrobot/body/robot_things.h"
#include "virtualrobot/worlds/height_grid.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

// The colour over the horizon.  It is grey, like the walls of a hall, because programs that play
// football would take a blue sky for the blue goal.
const Vector3d kBackground(0.66, 0.66, 0.65);

// Number of flat sides with which a cylinder is drawn.
constexpr int kSides = 24;
static_assert(kSides <= Face::kCornersMax);

// Unit vectors across a cylinder that is drawn with kSides flat sides: from its axis to each
// corner, and to the middle of the side that follows this corner.
struct CylinderSides {
  std::array<Vector3d, kSides> corners, middles;
  CylinderSides() {
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * kPi * i / kSides, half = kPi / kSides;
      corners[static_cast<size_t>(i)] = Vector3d(DetCos(angle), DetSin(angle), 0);
      middles[static_cast<size_t>(i)] = Vector3d(DetCos(angle + half), DetSin(angle + half), 0);
    }
  }
};

const CylinderSides& SharedSides() {
  static const CylinderSides round;
  return round;
}

class WorldPainter {
 public:
  WorldPainter(const World& world, Canvas* canvas) : world_(world), canvas_(canvas) {}

  void Draw(const WorldThing& thing) {
    if (!canvas_->MaySee(thing.centre_m, thing.size_m.norm() / 2)) return;
    switch (thing.shape) {
      case ThingShape::kBox:
        return DrawBox(thing);
      case ThingShape::kSphere:
        return canvas_->DrawBall(thing.centre_m, thing.size_m.x() / 2, thing.colour,
                                 world_.to_light, world_.ambient);
      case ThingShape::kCylinder:
        return DrawCylinder(thing);
      case ThingShape::kHeightField:
        return DrawHeights(thing);
    }
  }

  // Draws a box or a cylinder that is paint, by filling its outline on the floor.
  void DrawPaint(const WorldThing& thing) {
    Face face;
    const Vector3d half = thing.size_m / 2;
    const auto add = [&](double x, double y) {
      const Vector3d p = thing.centre_m + thing.R_WT * Vector3d(x, y, 0);
      face.Add({p.x(), p.y(), 0});
    };
    if (thing.shape == ThingShape::kBox) {
      add(half.x(), half.y());
      add(-half.x(), half.y());
      add(-half.x(), -half.y());
      add(half.x(), -half.y());
    } else {
      for (const Vector3d& corner : SharedSides().corners)
        add(corner.x() * half.x(), corner.y() * half.x());
    }
    canvas_->DrawPaint(face, RgbOf(thing.colour, BrightnessOf(Vector3d::UnitZ())));
  }

  // Returns the brightness, 0 to 1, of a face with the outward normal `normal_W` in the light of
  // the world.
  double BrightnessOf(const Vector3d& normal_W) const {
    return world_.ambient + (1 - world_.ambient) * std::max(0.0, normal_W.dot(world_.to_light));
  }

 private:
  void DrawFace(const WorldThing& thing, const Face& face, const Vector3d& normal_T) {
    const Vector3d normal_W = thing.R_WT * normal_T;
    canvas_->DrawFace(face, normal_W, RgbOf(thing.colour, BrightnessOf(normal_W)));
  }

  void DrawBox(const WorldThing& thing) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d half = thing.size_m / 2;
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      for (const double side : {1.0, -1.0}) {
        Face face;
        for (const auto& [u, v] : {std::array{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
          Vector3d corner;
          corner[axis] = side * half[axis];
          corner[next] = u * half[next];
          corner[last] = v * half[last];
          face.Add(thing.centre_m + thing.R_WT * corner);
        }
        DrawFace(thing, face, side * Vector3d::Unit(axis));
      }
    }
  }

  void DrawCylinder(const WorldThing& thing) {
    const double radius_m = thing.size_m.x() / 2, half_m = thing.size_m.z() / 2;
    const CylinderSides& round = SharedSides();
    Face top, bottom;
    for (const Vector3d& corner : round.corners) {
      const Vector3d middle = thing.centre_m + thing.R_WT * (corner * radius_m);
      top.Add(middle + thing.R_WT.col(2) * half_m);
      bottom.Add(middle - thing.R_WT.col(2) * half_m);
    }
    DrawFace(thing, top, Vector3d::UnitZ());
    DrawFace(thing, bottom, -Vector3d::UnitZ());
    for (int i = 0; i < kSides; ++i) {
      const int next = (i + 1) % kSides;
      Face side;
      side.Add(top.corner(i));
      side.Add(top.corner(next));
      side.Add(bottom.corner(next));
      side.Add(bottom.corner(i));
      DrawFace(thing, side, round.middles[static_cast<size_t>(i)]);
    }
  }

  void DrawHeights(const WorldThing& thing) {
    for (const Triangle& triangle : OutsideOf(thing)) {
      Face face;
      for (const Vector3d& corner : triangle) face.Add(thing.centre_m + thing.R_WT * corner);
      DrawFace(thing, face, NormalOf(triangle));
    }
  }

  const World& world_;
  Canvas* const canvas_;
};

}  // namespace

void DrawWorld(const CameraShot& shot, const World& world, const std::vector<WorldThing>& things,
               Canvas* canvas, Picture* picture) {
  WorldPainter painter(world, canvas);
  const RgbBytes floor = RgbOf(world.floor_colour, painter.BrightnessOf(Vector3d::UnitZ()));
  canvas->Begin(shot, floor, RgbOf(kBackground, 1), picture);
  for (const WorldThing& thing : things) {
    if (!thing.is_solid) painter.DrawPaint(thing);
  }
  for (const WorldThing& thing : things) {
    if (thing.is_solid) painter.Draw(thing);
  }
}

RenderedWorld::RenderedWorld(const RobotModel& model) : model_(model) {
  // Finds the parts of the head, because the camera, which is in the head, does not see them.  A
  // part belongs to the head if it carries the camera, or if its parent belongs to the head.
  for (size_t i = 0; i < model.bodies.size(); ++i) {
    const int joint = model.bodies[i].joint;
    const auto parent = joint < 0 ? -1 : model.joints[static_cast<size_t>(joint)].parent;
    is_head_.push_back(static_cast<int>(i) == model.camera.body ||
                       (parent >= 0 && is_head_[static_cast<size_t>(parent)]));
  }
}

std::string RenderedWorld::Capture(const CameraShot& shot, Picture* picture) {
  ASSERT(shot.body != nullptr, "a picture of the world without a body");
  std::vector<WorldThing> things = shot.body->Surroundings();
  for (WorldThing& part : ThingsOfRobot(model_, shot.body->BodyPoses(), is_head_))
    things.push_back(std::move(part));
  DrawWorld(shot, shot.body->world(), things, &canvas_, picture);
  return "";
}

}  // namespace openr_host
