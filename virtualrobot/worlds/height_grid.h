// The surface of a heightfield: a grid of points with heights.  Each square of four neighbouring
// points is filled with two triangles.
//
// All places are in the axes T of the thing, whose origin is the centre of its box.  Heights are
// over the lower face of this box.  The thing is solid between this face and the surface.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "virtualrobot/worlds/world.h"

namespace openr_host {

struct HeightGrid {
  int columns = 0, rows = 0;  // numbers of grid points along x and y, 2 or more each
  // Heights of the points of the heightfield, row by row.  The first row has the least y, and the
  // first point of each row has the least x.
  std::vector<double> heights_m;

  double At(int column, int row) const {
    return heights_m[static_cast<size_t>(row) * static_cast<size_t>(columns) +
                     static_cast<size_t>(column)];
  }
};

using Triangle = std::array<Eigen::Vector3d, 3>;

// Returns the point of the grid with this column and row.  REQUIRES: `thing` is a heightfield.  All
// functions below with a parameter `thing` require this, too.
Eigen::Vector3d PointOfGrid(const WorldThing& thing, int column, int row);

// Returns the two triangles of the square whose first corner is the point with this column and row.
// Seen from above, the corners of each triangle are in counterclockwise order.
std::array<Triangle, 2> TrianglesOf(const WorldThing& thing, int column, int row);

// Returns the triangles of the surface of the heightfield `thing` and of the sides below the
// surface's edges.  Seen from outside, the corners of each triangle are in counterclockwise order.
std::vector<Triangle> OutsideOf(const WorldThing& thing);

// Returns the unit vector that is perpendicular to `triangle` and points outwards; 0 if the
// triangle has no area.
Eigen::Vector3d NormalOf(const Triangle& triangle);

struct SurfacePoint {
  double height_m = 0;  // height over the lower face of the box that holds the heightfield
  Eigen::Vector3d normal_T{0, 0, 1};  // normal of the surface, a unit vector
};

// Returns the point of the surface of `thing` at (x, y).  If (x, y) is not in the grid, returns the
// nearest point of the grid's edge.
SurfacePoint SurfaceAt(const WorldThing& thing, double x, double y);

// Follows the ray p + t d for t from `enter` to `leave`, the range in which the ray is in the box
// of the heightfield `thing`.  Returns the least t at which the ray is in the solid; infinite if
// the ray does not meet the solid.
double CastRayOnHeights(const WorldThing& thing, const Eigen::Vector3d& p, const Eigen::Vector3d& d,
                        double enter, double leave);

}  // namespace openr_host
