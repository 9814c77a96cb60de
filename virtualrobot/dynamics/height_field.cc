#include "virtualrobot/dynamics/height_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/base/assert.h"
#include "virtualrobot/worlds/height_grid.h"

namespace openr_host {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Two points at which a ball touches a heightfield count as one point when the cosine of the angle
// between their normals is above this number.
constexpr double kSameNormal = 0.99;

// A range of squares of a heightfield's grid along one axis: from `begin` to `end` - 1.
struct Squares {
  int begin = 0, end = 0;
};

// Returns the squares of a heightfield's grid that overlap the range from `low` to `high`, in m,
// along one axis.  The grid has `count` points over the length `size_m` of this axis.
Squares SquaresBetween(double low, double high, double size_m, int count) {
  const double per_m = (count - 1) / size_m, last = count - 1;
  const auto begin = static_cast<int>(std::clamp((low + size_m / 2) * per_m, 0.0, last));
  const auto end = static_cast<int>(std::clamp((high + size_m / 2) * per_m, -1.0, last - 1)) + 1;
  return {begin, end};
}

// Returns the point of `triangle` that is nearest to `p`.
Vector3d NearestOf(const Triangle& triangle, const Vector3d& p) {
  const Vector3d normal = NormalOf(triangle);
  const Vector3d below = p - normal * normal.dot(p - triangle[0]);
  std::optional<Vector3d> nearest;
  for (size_t i = 0; i < 3; ++i) {
    const Vector3d &a = triangle[i], &b = triangle[(i + 1) % 3];
    const Vector3d edge = b - a;
    // Skips an edge of the triangle if `below`, the point of the triangle's plane under `p`, is on
    // the inner side of the edge, because then the nearest point is not beyond this edge.
    if (edge.cross(below - a).dot(normal) >= 0) continue;
    const double share = std::clamp(edge.dot(p - a) / edge.squaredNorm(), 0.0, 1.0);
    const Vector3d on_edge = a + share * edge;
    if (!nearest || (on_edge - p).squaredNorm() < (*nearest - p).squaredNorm()) nearest = on_edge;
  }
  return nearest.value_or(below);
}

bool IsOverBase(const WorldThing& thing, const Vector3d& p) {
  return std::fabs(p.x()) <= thing.size_m.x() / 2 && std::fabs(p.y()) <= thing.size_m.y() / 2;
}

// Returns how high the point `p` is above `surface`, the point of the heightfield with the same x
// and y.  `p` is in the axes T of the thing.
double HeightOver(const WorldThing& thing, const Vector3d& p, const SurfacePoint& surface) {
  return p.z() + thing.size_m.z() / 2 - surface.height_m;
}

// Returns the point at which a ball touches a side of the heightfield.  Returns nullopt if the
// centre `p` of the ball is not beside the heightfield, or if the ball does not touch it.
std::optional<TouchPoint> TouchSide(const WorldThing& thing, const Vector3d& p, double radius_m) {
  const Vector3d half = thing.size_m / 2;
  Vector3d nearest = p.cwiseMax(-half).cwiseMin(half);
  const SurfacePoint surface = SurfaceAt(thing, nearest.x(), nearest.y());
  // Lowers the point to the height of the surface, because the sides of the heightfield reach up
  // only to the surface, and not to the top of the box around it.
  nearest.z() = std::min(nearest.z(), surface.height_m - half.z());
  const Vector3d way = p - nearest;
  const double distance_m = way.norm();
  // Returns nothing for a centre that is exactly on the side, because the direction in which the
  // side would push the ball is not known.
  if (distance_m >= radius_m || distance_m == 0) return std::nullopt;
  const Vector3d out = way / distance_m;
  return TouchPoint{p - radius_m * out, out, radius_m - distance_m};
}

// Adds to `found` the points at which a ball touches triangles of the surface.  REQUIRES: the
// centre `p` of the ball is above the rectangle that the heightfield covers.
void TouchTriangles(const WorldThing& thing, const Vector3d& p, double radius_m,
                    std::vector<TouchPoint>* found) {
  const HeightGrid& grid = *thing.heights;
  const Squares columns =
      SquaresBetween(p.x() - radius_m, p.x() + radius_m, thing.size_m.x(), grid.columns);
  const Squares rows =
      SquaresBetween(p.y() - radius_m, p.y() + radius_m, thing.size_m.y(), grid.rows);
  for (int row = rows.begin; row < rows.end; ++row) {
    for (int column = columns.begin; column < columns.end; ++column) {
      for (const Triangle& triangle : TrianglesOf(thing, column, row)) {
        const Vector3d way = p - NearestOf(triangle, p);
        const double distance_m = way.norm();
        if (distance_m >= radius_m || distance_m == 0) continue;
        const Vector3d out = way / distance_m;
        // Ignores a triangle if the ball's centre is below it, because the triangle would push the
        // ball downwards.
        if (out.dot(NormalOf(triangle)) > 0)
          found->push_back({p - radius_m * out, out, radius_m - distance_m});
      }
    }
  }
}

// Adds the deepest of the contact points `found` to `points`: at most kHeightPointsMax, the deepest
// first.  Leaves out a point if `is_same` says that it is the same contact as a deeper point.
// Converts the points from the axes T of the thing to the world W.
template <typename IsSame>
void AddDeepest(std::vector<TouchPoint> found, const WorldThing& thing, IsSame is_same,
                std::vector<TouchPoint>* points) {
  std::stable_sort(found.begin(), found.end(),
                   [](const TouchPoint& a, const TouchPoint& b) { return a.depth_m > b.depth_m; });
  std::vector<TouchPoint> kept;
  for (const TouchPoint& point : found) {
    if (std::any_of(kept.begin(), kept.end(),
                    [&](const TouchPoint& other) { return is_same(point, other); }))
      continue;
    kept.push_back(point);
    points->push_back(
        {thing.centre_m + thing.R_WT * point.p_W, thing.R_WT * point.normal_W, point.depth_m});
    if (kept.size() == kHeightPointsMax) return;
  }
}

}  // namespace

void TouchBallOnHeights(const Vector3d& centre_W, double radius_m, const WorldThing& thing,
                        std::vector<TouchPoint>* points) {
  ASSERT(thing.shape == ThingShape::kHeightField, "{}: is no heightfield", thing.name);
  const Vector3d p = thing.R_WT.transpose() * (centre_W - thing.centre_m);
  if ((p.cwiseAbs() - thing.size_m / 2).maxCoeff() >= radius_m) return;
  std::vector<TouchPoint> found;
  if (!IsOverBase(thing, p)) {
    if (const auto side = TouchSide(thing, p, radius_m)) found.push_back(*side);
  } else {
    const SurfacePoint surface = SurfaceAt(thing, p.x(), p.y());
    const double height_m = HeightOver(thing, p, surface) * surface.normal_T.z();
    // If the centre of the ball is below the surface, pushes the ball out along the normal of the
    // surface at the point above the centre, because TouchTriangles() ignores a triangle if the
    // centre is below it.
    if (height_m <= 0) {
      found.push_back({p - radius_m * surface.normal_T, surface.normal_T, radius_m - height_m});
    } else {
      TouchTriangles(thing, p, radius_m, &found);
    }
  }
  const auto is_same = [](const TouchPoint& a, const TouchPoint& b) {
    return a.normal_W.dot(b.normal_W) > kSameNormal;
  };
  AddDeepest(std::move(found), thing, is_same, points);
}

void TouchBoxOnHeights(const Vector3d& centre_W, const Matrix3d& R_WB, const Vector3d& size_m,
                       const WorldThing& thing, std::vector<TouchPoint>* points) {
  ASSERT(thing.shape == ThingShape::kHeightField, "{}: is no heightfield", thing.name);
  const Matrix3d R = thing.R_WT.transpose() * R_WB;
  const Vector3d centre = thing.R_WT.transpose() * (centre_W - thing.centre_m);
  const Vector3d reach = R.cwiseAbs() * size_m / 2;
  if ((centre.cwiseAbs() - reach - thing.size_m / 2).maxCoeff() >= 0) return;
  std::vector<TouchPoint> found;
  for (int i = 0; i < 8; ++i) {
    const Vector3d sign(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    const Vector3d corner = centre + R * sign.cwiseProduct(size_m);
    // Leaves out a corner below the lower face of the heightfield, because the corner is then under
    // the heightfield and not in it.
    if (!IsOverBase(thing, corner) || corner.z() < -thing.size_m.z() / 2) continue;
    const SurfacePoint surface = SurfaceAt(thing, corner.x(), corner.y());
    const double height_m = HeightOver(thing, corner, surface) * surface.normal_T.z();
    if (height_m < 0) found.push_back({corner, surface.normal_T, -height_m});
  }
  const HeightGrid& grid = *thing.heights;
  const Squares columns = SquaresBetween(centre.x() - reach.x(), centre.x() + reach.x(),
                                         thing.size_m.x(), grid.columns);
  const Squares rows =
      SquaresBetween(centre.y() - reach.y(), centre.y() + reach.y(), thing.size_m.y(), grid.rows);
  for (int row = rows.begin; row <= rows.end; ++row) {
    for (int column = columns.begin; column <= columns.end; ++column) {
      const Vector3d point = PointOfGrid(thing, column, row);
      const SurfaceDistance inside =
          DistanceTo(ThingShape::kBox, size_m, R.transpose() * (point - centre));
      if (inside.distance_m >= 0) continue;
      // Leaves out a point that would push the box downwards, because the box would then leave the
      // heightfield, which is solid, through its lower face.
      const Vector3d out = -(R * inside.out);
      if (out.z() > 0) found.push_back({point, out, -inside.distance_m});
    }
  }
  const auto is_same = [](const TouchPoint& a, const TouchPoint& b) { return a.p_W == b.p_W; };
  AddDeepest(std::move(found), thing, is_same, points);
}

}  // namespace openr_host
