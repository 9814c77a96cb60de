// Finds where balls, boxes and cylinders touch spheres and cylinders.
//
// ODE finds where balls and boxes touch boxes (ode/contact_finder.h).  ODE's colliders for
// cylinders are not used, because they call sine and cosine of libm, whose bits depend on the
// processor.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "virtualrobot/worlds/world.h"

namespace openr_host {

// A point at which a shape (a ball, a box or a cylinder) touches a thing.
struct TouchPoint {
  Eigen::Vector3d p_W{0, 0, 0};       // point of the shape or the thing that is inside the other
  Eigen::Vector3d normal_W{0, 0, 1};  // unit vector that points out of the thing
  double depth_m = 0;                 // depth of the shape in the thing, > 0
};

// Distance of a point from the surface of a shape, and the direction of the nearest way out.
struct SurfaceDistance {
  double distance_m = 0;         // distance to the surface; < 0 for a point inside the shape
  Eigen::Vector3d out{0, 0, 1};  // direction of the nearest way out, a unit vector
};

// Returns the distance of the point `p` from the surface of a shape.  `p` is in the shape's own
// axes, and the centre of the shape is the origin.
SurfaceDistance DistanceTo(ThingShape shape, const Eigen::Vector3d& size_m,
                           const Eigen::Vector3d& p);

// Adds to `points` the point at which a ball touches `thing`; adds nothing if they do not touch.
void TouchBall(const Eigen::Vector3d& centre_W, double radius_m, const WorldThing& thing,
               std::vector<TouchPoint>* points);

// TouchBox() adds to `points` the points, at most kBoxPointsMax, at which a box touches `thing`.
// REQUIRES: `thing` is a sphere or a cylinder.
inline constexpr int kBoxPointsMax = 8;
void TouchBox(const Eigen::Vector3d& centre_W, const Eigen::Matrix3d& R_WB,
              const Eigen::Vector3d& size_m, const WorldThing& thing,
              std::vector<TouchPoint>* points);

// Adds to `points` the points, at most kBoxPointsMax, at which `cylinder` touches `thing`.  They
// are points on the rims of both cylinders, and, for each cylinder, points on that straight line of
// its curved side which is nearest to the other cylinder.  REQUIRES: both are cylinders.
void TouchCylinders(const WorldThing& cylinder, const WorldThing& thing,
                    std::vector<TouchPoint>* points);

}  // namespace openr_host
