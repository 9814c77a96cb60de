#include "virtualrobot/dynamics/touch.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A face of a box touches the side of a cylinder only if the face is roughly parallel to the axis
// of the cylinder: in the axes of the cylinder, the absolute value of the z coordinate of the
// face's normal is at most this number.  All other faces touch an end of the cylinder.
constexpr double kUprightMax = 0.5;

// Number of test points on the rim of each end of a cylinder.  A test point that lies in another
// shape becomes a TouchPoint.
constexpr int kRimPoints = 8;

SurfaceDistance DistanceToBox(const Vector3d& half, const Vector3d& p) {
  const Vector3d nearest = p.cwiseMax(-half).cwiseMin(half);
  const Vector3d way = p - nearest;
  const double length = way.norm();
  if (length > 0) return {length, way / length};
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    // The point is in the box.  `axis` becomes the axis that leads to the nearest face, because the
    // shortest way out of the box is along this axis.
    if (half[k] - std::fabs(p[k]) < half[axis] - std::fabs(p[axis])) axis = k;
  }
  SurfaceDistance result{std::fabs(p[axis]) - half[axis], Vector3d::Zero()};
  result.out[axis] = p[axis] < 0 ? -1 : 1;
  return result;
}

SurfaceDistance DistanceToCylinder(const Vector3d& half, const Vector3d& p) {
  const double across = std::sqrt(p.x() * p.x() + p.y() * p.y());
  // If the point is on the axis of the cylinder, takes the x axis as the direction to the side,
  // because the side is equally near in every direction.
  const Vector3d level =
      across > 0 ? Vector3d(p.x() / across, p.y() / across, 0) : Vector3d::UnitX();
  const Vector3d up(0, 0, p.z() < 0 ? -1 : 1);
  const double beside = across - half.x(), above = std::fabs(p.z()) - half.z();
  if (beside > 0 && above > 0) {
    const double length = std::sqrt(beside * beside + above * above);
    return {length, (beside * level + above * up) / length};
  }
  return beside > above ? SurfaceDistance{beside, level} : SurfaceDistance{above, up};
}

// Returns the point of the line from `a` to `b` that is nearest to the z axis.  If a part of the
// line is between the heights -half and half, only this part counts.
Vector3d NearestToAxis(const Vector3d& a, const Vector3d& b, double half) {
  const Vector3d d = b - a;
  double from = 0, to = 1;
  if (d.z() != 0) {
    double low = (-half - a.z()) / d.z(), high = (half - a.z()) / d.z();
    if (low > high) std::swap(low, high);
    from = std::clamp(low, 0.0, 1.0);
    to = std::clamp(high, 0.0, 1.0);
  }
  const double across2 = d.x() * d.x() + d.y() * d.y();
  const double t = across2 > 0 ? -(a.x() * d.x() + a.y() * d.y()) / across2 : from;
  return a + std::clamp(t, from, to) * d;
}

// Adds, for each edge of the box that reaches into the cylinder `thing`, the point of this edge
// that is nearest to the axis of the cylinder.  Vectors are in the axes of the cylinder.
void TouchByEdges(const Vector3d& centre, const Matrix3d& R, const Vector3d& half,
                  const WorldThing& thing, std::vector<TouchPoint>* points) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 4; ++side) {
      Vector3d corner = half;
      if (side & 1) corner[(axis + 1) % 3] *= -1;
      if (side & 2) corner[(axis + 2) % 3] *= -1;
      Vector3d other = corner;
      other[axis] *= -1;
      const Vector3d p =
          NearestToAxis(centre + R * corner, centre + R * other, thing.size_m.z() / 2);
      const SurfaceDistance found = DistanceTo(thing.shape, thing.size_m, p);
      if (found.distance_m < 0) points->push_back({p, found.out, -found.distance_m});
    }
  }
}

// Returns the length, in m, by which the box and the cylinder `thing` overlap along the axis of the
// cylinder.
double OverlapAlongAxis(const Vector3d& centre, const Matrix3d& R, const Vector3d& half,
                        const WorldThing& thing) {
  const double reach =
      std::fabs(R(2, 0)) * half.x() + std::fabs(R(2, 1)) * half.y() + std::fabs(R(2, 2)) * half.z();
  return thing.size_m.z() / 2 + reach - std::fabs(centre.z());
}

// Adds points of the side of the cylinder `thing` that are inside the box.  Tests the side at three
// heights: at the middle and at the two ends of the cylinder.  Leaves out a point whose depth is
// greater than OverlapAlongAxis(), because the box then touches an end of the cylinder and not its
// side.
void TouchByFaces(const Vector3d& centre, const Matrix3d& R, const Vector3d& half,
                  const WorldThing& thing, std::vector<TouchPoint>* points) {
  const double radius_m = thing.size_m.x() / 2;
  const double depth_max_m = OverlapAlongAxis(centre, R, half, thing);
  for (const double share : {-0.5, 0.0, 0.5}) {
    const Vector3d axis_point(0, 0, share * thing.size_m.z());
    const SurfaceDistance found =
        DistanceTo(ThingShape::kBox, 2 * half, R.transpose() * (axis_point - centre));
    const Vector3d out = R * found.out;  // direction out of the box
    const double depth_m = radius_m - found.distance_m;
    if (depth_m <= 0 || depth_m > depth_max_m || std::fabs(out.z()) > kUprightMax) continue;
    points->push_back({axis_point - radius_m * out, -out, depth_m});
  }
}

// Returns point `i` on the rim of an end of a cylinder, in the cylinder's axes.  `end` is -0.5 for
// the lower end and 0.5 for the upper end.
Vector3d RimPoint(const Vector3d& size_m, double end, int i) {
  constexpr double kHalfRoot = 0.70710678118654752440;  // sine and cosine of 45 degrees
  constexpr double kX[kRimPoints] = {1, kHalfRoot, 0, -kHalfRoot, -1, -kHalfRoot, 0, kHalfRoot};
  const double radius_m = size_m.x() / 2;
  return {radius_m * kX[i], radius_m * kX[(i + kRimPoints - 2) % kRimPoints], end * size_m.z()};
}

// Adds those points on the rims of the cylinder's two ends that are in the box.
void TouchByRims(const Vector3d& centre, const Matrix3d& R, const Vector3d& half,
                 const WorldThing& thing, std::vector<TouchPoint>* points) {
  for (const double end : {-0.5, 0.5}) {
    for (int i = 0; i < kRimPoints; ++i) {
      const Vector3d p = RimPoint(thing.size_m, end, i);
      const SurfaceDistance found =
          DistanceTo(ThingShape::kBox, 2 * half, R.transpose() * (p - centre));
      if (found.distance_m < 0) points->push_back({p, -(R * found.out), -found.distance_m});
    }
  }
}

// Adds points of the cylinder `tested` that are inside the cylinder `other`.  Tests points on the
// two rims of `tested`, the circles around its flat ends.  Also tests three points on the curved
// side of `tested`: they are on the line along the side that is nearest to `other`.  None of the
// three points is close to an end of `tested`.  A point there could be close to a flat end of
// `other`, too, and the shortest way out of `other` would then lead through that end and not
// through the side of `other`.
// `sign` is 1 if normals are to point out of `other`, and -1 if normals are to point into `other`.
void TouchByRimsAndSide(const WorldThing& tested, const WorldThing& other, double sign,
                        std::vector<TouchPoint>* points) {
  const auto test = [&](const Vector3d& p) {
    const Vector3d p_W = tested.centre_m + tested.R_WT * p;
    const SurfaceDistance found =
        DistanceTo(other.shape, other.size_m, other.R_WT.transpose() * (p_W - other.centre_m));
    if (found.distance_m < 0)
      points->push_back({p_W, sign * (other.R_WT * found.out), -found.distance_m});
  };
  for (const double end : {-0.5, 0.5}) {
    for (int i = 0; i < kRimPoints; ++i) test(RimPoint(tested.size_m, end, i));
  }
  const Vector3d way = tested.R_WT.transpose() * (other.centre_m - tested.centre_m);
  const double length = std::sqrt(way.x() * way.x() + way.y() * way.y());
  // Tests no points on the side of `tested` if the centre of `other` is on the axis of `tested`,
  // because all lines of the side are then equally near to this centre.
  if (length == 0) return;
  const double scale = tested.size_m.x() / 2 / length;
  for (const double height : {-0.4, 0.0, 0.4})
    test(Vector3d(way.x() * scale, way.y() * scale, height * tested.size_m.z()));
}

// Sorts `points` by depth, the deepest first, and keeps only the first kBoxPointsMax points.
// Points of equal depth keep their order.
void KeepDeepestPoints(std::vector<TouchPoint>* points) {
  std::stable_sort(points->begin(), points->end(),
                   [](const TouchPoint& a, const TouchPoint& b) { return a.depth_m > b.depth_m; });
  if (points->size() > kBoxPointsMax) points->resize(kBoxPointsMax);
}

}  // namespace

SurfaceDistance DistanceTo(ThingShape shape, const Vector3d& size_m, const Vector3d& p) {
  const Vector3d half = size_m / 2;
  if (shape == ThingShape::kBox) return DistanceToBox(half, p);
  if (shape == ThingShape::kCylinder) return DistanceToCylinder(half, p);
  const double length = p.norm();
  return {length - half.x(), length > 0 ? Vector3d(p / length) : Vector3d::UnitZ()};
}

void TouchBall(const Vector3d& centre_W, double radius_m, const WorldThing& thing,
               std::vector<TouchPoint>* points) {
  const SurfaceDistance found =
      DistanceTo(thing.shape, thing.size_m, thing.R_WT.transpose() * (centre_W - thing.centre_m));
  if (found.distance_m >= radius_m) return;
  const Vector3d out_W = thing.R_WT * found.out;
  points->push_back({centre_W - radius_m * out_W, out_W, radius_m - found.distance_m});
}

void TouchBox(const Vector3d& centre_W, const Matrix3d& R_WB, const Vector3d& size_m,
              const WorldThing& thing, std::vector<TouchPoint>* points) {
  ASSERT(thing.shape != ThingShape::kBox, "{}: ODE serves pairs of boxes", thing.name);
  const Vector3d half = size_m / 2;
  if (thing.shape == ThingShape::kSphere) {
    const double radius_m = thing.size_m.x() / 2;
    const SurfaceDistance found =
        DistanceTo(ThingShape::kBox, size_m, R_WB.transpose() * (thing.centre_m - centre_W));
    if (found.distance_m >= radius_m) return;
    const Vector3d out_W = R_WB * found.out;  // direction out of the box
    points->push_back({thing.centre_m - radius_m * out_W, -out_W, radius_m - found.distance_m});
    return;
  }
  std::vector<TouchPoint> found;
  const Vector3d centre = thing.R_WT.transpose() * (centre_W - thing.centre_m);
  const Matrix3d R = thing.R_WT.transpose() * R_WB;
  TouchByFaces(centre, R, half, thing, &found);
  TouchByEdges(centre, R, half, thing, &found);
  TouchByRims(centre, R, half, thing, &found);
  KeepDeepestPoints(&found);
  for (TouchPoint& point : found) {
    point.p_W = thing.centre_m + thing.R_WT * point.p_W;
    point.normal_W = thing.R_WT * point.normal_W;
    points->push_back(point);
  }
}

void TouchCylinders(const WorldThing& cylinder, const WorldThing& thing,
                    std::vector<TouchPoint>* points) {
  ASSERT(cylinder.shape == ThingShape::kCylinder && thing.shape == ThingShape::kCylinder,
         "{} and {}", cylinder.name, thing.name);
  std::vector<TouchPoint> found;
  TouchByRimsAndSide(cylinder, thing, 1, &found);
  TouchByRimsAndSide(thing, cylinder, -1, &found);
  KeepDeepestPoints(&found);
  points->insert(points->end(), found.begin(), found.end());
}

}  // namespace openr_host
