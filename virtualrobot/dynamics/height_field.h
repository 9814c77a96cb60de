// Finds where balls and boxes touch a heightfield.  ODE's own collider for heightfields is not
// used, because it calls libm, whose bits depend on the processor.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "virtualrobot/dynamics/touch.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {

// TouchBallOnHeights() adds to `points` the points, at most kHeightPointsMax, at which a ball
// touches the heightfield `thing`, the deepest first.  There can be more than one point, because a
// ball in a valley touches both sides of the valley.
inline constexpr int kHeightPointsMax = 8;
void TouchBallOnHeights(const Eigen::Vector3d& centre_W, double radius_m, const WorldThing& thing,
                        std::vector<TouchPoint>* points);

// Adds the points, at most kHeightPointsMax, at which a box touches the heightfield `thing`, the
// deepest first: corners of the box below the surface, and points of the grid in the box.  Does not
// find the points at which an edge of the box crosses an edge of the surface.
void TouchBoxOnHeights(const Eigen::Vector3d& centre_W, const Eigen::Matrix3d& R_WB,
                       const Eigen::Vector3d& size_m, const WorldThing& thing,
                       std::vector<TouchPoint>* points);

}  // namespace openr_host
