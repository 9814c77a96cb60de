#include "virtualrobot/worlds/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "runtime/base/hasher.h"
#include "virtualrobot/worlds/height_grid.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

constexpr double kNever = std::numeric_limits<double>::infinity();

// The part of a ray that is inside a shape: from p + enter * d to p + leave * d for the ray p + t *
// d.
struct RayPart {
  double enter = 0, leave = kNever;

  void Cut(double from, double to) {
    if (from > to) std::swap(from, to);
    enter = std::max(enter, from);
    leave = std::min(leave, to);
  }
  void Miss() { leave = -1; }
  double Distance() const { return enter <= leave ? enter : kNever; }
};

// Cuts `inside` to the part of the ray between two planes, which cross one axis at -half and half.
// On this axis, `p` is the coordinate of the start of the ray, and `d` that of its direction.
void CutBySlab(double p, double d, double half, RayPart* inside) {
  if (d != 0) {
    inside->Cut((-half - p) / d, (half - p) / d);
  } else if (std::fabs(p) > half) {
    inside->Miss();
  }
}

// Cuts `inside` to the part of the ray p + t * d that is within `radius` of the origin.  The ray
// has two coordinates (for a cylinder) or three (for a ball).
template <typename Vector>
void CutByBall(const Vector& p, const Vector& d, double radius, RayPart* inside) {
  const double a = d.squaredNorm(), b = p.dot(d), c = p.squaredNorm() - radius * radius;
  if (a == 0) {
    if (c > 0) inside->Miss();
    return;
  }
  const double root = b * b - a * c;
  if (root < 0) return inside->Miss();
  inside->Cut((-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a);
}

// Returns the least t >= 0 at which the ray p_W + t * direction_W is inside `thing`: infinite when
// the ray misses the thing, 0 when it starts inside.
double EnterThing(const WorldThing& thing, const Vector3d& p_W, const Vector3d& direction_W) {
  const Vector3d p = thing.R_WT.transpose() * (p_W - thing.centre_m);
  const Vector3d d = thing.R_WT.transpose() * direction_W;
  const Vector3d half = thing.size_m / 2;
  RayPart inside;
  switch (thing.shape) {
    case ThingShape::kBox:
    case ThingShape::kHeightField:
      for (int k = 0; k < 3; ++k) CutBySlab(p[k], d[k], half[k], &inside);
      break;
    case ThingShape::kSphere:
      CutByBall(p, d, half.x(), &inside);
      break;
    case ThingShape::kCylinder:
      CutBySlab(p.z(), d.z(), half.z(), &inside);
      CutByBall(Eigen::Vector2d(p.head<2>()), Eigen::Vector2d(d.head<2>()), half.x(), &inside);
      break;
  }
  if (thing.shape == ThingShape::kHeightField && inside.enter <= inside.leave)
    return CastRayOnHeights(thing, p, d, inside.enter, inside.leave);
  return inside.Distance();
}

}  // namespace

void CastRayOnThings(const std::vector<WorldThing>& things, const Vector3d& p_W,
                     const Vector3d& direction_W, RayHit* hit) {
  for (const WorldThing& thing : things) {
    if (!thing.is_solid) continue;
    const double distance_m = EnterThing(thing, p_W, direction_W);
    if (distance_m < hit->distance_m) *hit = {distance_m, thing.reflectance};
  }
}

RayHit CastRay(const World& world, const std::vector<WorldThing>& things, const Vector3d& p_W,
               const Vector3d& direction_W, double max_m) {
  if (p_W.z() <= 0) return {0, world.floor_reflectance};
  RayHit hit{max_m, 1};
  if (direction_W.z() < 0 && -p_W.z() / direction_W.z() < max_m)
    hit = {-p_W.z() / direction_W.z(), world.floor_reflectance};
  CastRayOnThings(things, p_W, direction_W, &hit);
  return hit;
}

StartPlace StartOf(const World& world, int robot) {
  constexpr double kApart_m = 0.5;
  if (world.starts.empty()) {
    const int steps = (robot + 1) / 2;  // places the robots to the left and to the right in turn
    return {.y_m = (robot % 2 == 1 ? steps : -steps) * kApart_m};
  }
  if (static_cast<size_t>(robot) >= world.starts.size()) {
    throw std::runtime_error(fmt::format(
        "the world '{}' has places for {} (starts); robot {} has none; add a place, or take fewer "
        "robots",
        world.name,
        world.starts.size() == 1 ? "1 robot" : fmt::format("{} robots", world.starts.size()),
        robot));
  }
  return world.starts[static_cast<size_t>(robot)];
}

void HashWorld(const World& world, Hasher* hasher) {
  hasher->Add(world.floor_friction);
  if (world.floor_reflectance != 1) hasher->Add(world.floor_reflectance);
  for (const WorldThing& thing : world.things) {
    hasher->Add(thing.shape);
    hasher->AddBytes(thing.size_m.data(), 3 * sizeof(double));
    hasher->AddBytes(thing.centre_m.data(), 3 * sizeof(double));
    hasher->AddBytes(thing.R_WT.data(), 9 * sizeof(double));
    // Adds only values that differ from the defaults.  So when WorldThing gets a new member, the
    // hash of a world that does not use this member stays the same.  Leaves out colours and light,
    // because they change only images, and the bytes of an image are hashed when an object receives
    // it.
    if (thing.mass_kg > 0) hasher->Add(thing.mass_kg);
    if (!thing.is_solid) hasher->Add(thing.is_solid);
    if (thing.reflectance != 1) hasher->Add(thing.reflectance);
    if (thing.heights == nullptr) continue;
    hasher->Add(thing.heights->columns);
    for (const double height_m : thing.heights->heights_m) hasher->Add(height_m);
  }
}

}  // namespace openr_host
