#include "virtualrobot/worlds/height_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace openr_host {
namespace {

using Eigen::Vector3d;

// A place on the grid of a heightfield: column and row of the square in which the place lies, and
// the coordinates of the place in this square, 0 to 1.
struct GridPlace {
  int column = 0, row = 0;
  double u = 0, v = 0;
};

// Converts the coordinate `x` on a heightfield, in m from the middle of the grid, to a position on
// the grid that counts its points: 0 is the first point, `count` - 1 the last.  The grid has
// `count` points over the length `size_m`.
double InPoints(double x, double size_m, int count) { return (x / size_m + 0.5) * (count - 1); }

GridPlace PlaceOnGrid(const WorldThing& thing, double x, double y) {
  const HeightGrid& grid = *thing.heights;
  const double u = std::clamp(InPoints(x, thing.size_m.x(), grid.columns), 0.0,
                              static_cast<double>(grid.columns - 1));
  const double v =
      std::clamp(InPoints(y, thing.size_m.y(), grid.rows), 0.0, static_cast<double>(grid.rows - 1));
  GridPlace place;
  place.column = std::min(static_cast<int>(u), grid.columns - 2);
  place.row = std::min(static_cast<int>(v), grid.rows - 2);
  place.u = u - place.column;
  place.v = v - place.row;
  return place;
}

// Adds to `found` each t between `enter` and `leave` at which at + t * step is a whole number.  At
// these t, a ray crosses the lines of a heightfield's grid.
void AddCrossings(double at, double step, double enter, double leave, std::vector<double>* found) {
  if (step == 0) return;
  double from = at + enter * step, to = at + leave * step;
  if (from > to) std::swap(from, to);
  // Begins one line of the grid early, because the conversion to int rounds a negative number up.
  for (int line = static_cast<int>(from) - 1; line <= to + 1; ++line) {
    const double t = (line - at) / step;
    if (t > enter && t < leave) found->push_back(t);
  }
}

}  // namespace

Vector3d PointOfGrid(const WorldThing& thing, int column, int row) {
  const HeightGrid& grid = *thing.heights;
  const double u = static_cast<double>(column) / (grid.columns - 1);
  const double v = static_cast<double>(row) / (grid.rows - 1);
  return {(u - 0.5) * thing.size_m.x(), (v - 0.5) * thing.size_m.y(),
          grid.At(column, row) - thing.size_m.z() / 2};
}

std::array<Triangle, 2> TrianglesOf(const WorldThing& thing, int column, int row) {
  const Vector3d near = PointOfGrid(thing, column, row);
  const Vector3d far = PointOfGrid(thing, column + 1, row + 1);
  return {Triangle{near, PointOfGrid(thing, column + 1, row), far},
          Triangle{near, far, PointOfGrid(thing, column, row + 1)}};
}

std::vector<Triangle> OutsideOf(const WorldThing& thing) {
  const HeightGrid& grid = *thing.heights;
  std::vector<Triangle> triangles;
  for (int row = 0; row + 1 < grid.rows; ++row) {
    for (int column = 0; column + 1 < grid.columns; ++column) {
      for (const Triangle& triangle : TrianglesOf(thing, column, row))
        triangles.push_back(triangle);
    }
  }
  // Adds two triangles: the part of the heightfield's side below the edge from point `a` to point
  // `b` of the surface.  Seen from outside, `b` is to the left of `a`.
  const auto add_side = [&](const Vector3d& a, const Vector3d& b) {
    const Vector3d below_a(a.x(), a.y(), -thing.size_m.z() / 2);
    const Vector3d below_b(b.x(), b.y(), below_a.z());
    triangles.push_back({a, b, below_b});
    triangles.push_back({a, below_b, below_a});
  };
  const int last_column = grid.columns - 1, last_row = grid.rows - 1;
  for (int i = 0; i < last_column; ++i) {
    add_side(PointOfGrid(thing, i + 1, 0), PointOfGrid(thing, i, 0));
    add_side(PointOfGrid(thing, i, last_row), PointOfGrid(thing, i + 1, last_row));
  }
  for (int i = 0; i < last_row; ++i) {
    add_side(PointOfGrid(thing, 0, i), PointOfGrid(thing, 0, i + 1));
    add_side(PointOfGrid(thing, last_column, i + 1), PointOfGrid(thing, last_column, i));
  }
  return triangles;
}

Vector3d NormalOf(const Triangle& triangle) {
  return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
}

SurfacePoint SurfaceAt(const WorldThing& thing, double x, double y) {
  const GridPlace place = PlaceOnGrid(thing, x, y);
  const Triangle triangle = TrianglesOf(thing, place.column, place.row)[place.u >= place.v ? 0 : 1];
  const HeightGrid& grid = *thing.heights;
  const double near = grid.At(place.column, place.row);
  const double far = grid.At(place.column + 1, place.row + 1);
  const double right = grid.At(place.column + 1, place.row);
  const double left = grid.At(place.column, place.row + 1);
  const double height_m = place.u >= place.v
                              ? near + place.u * (right - near) + place.v * (far - right)
                              : near + place.v * (left - near) + place.u * (far - left);
  return {height_m, NormalOf(triangle)};
}

double CastRayOnHeights(const WorldThing& thing, const Vector3d& p, const Vector3d& d, double enter,
                        double leave) {
  const HeightGrid& grid = *thing.heights;
  // Returns the height, over the surface of the heightfield, of the point of the ray at `t`;
  // negative below the surface.
  const auto over = [&](double t) {
    const Vector3d at = p + t * d;
    return at.z() + thing.size_m.z() / 2 - SurfaceAt(thing, at.x(), at.y()).height_m;
  };
  // Divides the ray at its crossings with the lines of the grid and with the diagonals of its
  // squares, because the surface of the heightfield is flat between these lines.  So between two
  // crossings, the height `over` of the ray above the surface is linear in t, and the ray enters
  // the solid where `over` becomes 0.
  const double u = InPoints(p.x(), thing.size_m.x(), grid.columns);
  const double v = InPoints(p.y(), thing.size_m.y(), grid.rows);
  const double du = d.x() / thing.size_m.x() * (grid.columns - 1);
  const double dv = d.y() / thing.size_m.y() * (grid.rows - 1);
  std::vector<double> crossings = {enter, leave};
  AddCrossings(u, du, enter, leave, &crossings);
  AddCrossings(v, dv, enter, leave, &crossings);
  AddCrossings(u - v, du - dv, enter, leave, &crossings);
  std::sort(crossings.begin(), crossings.end());
  double before = over(enter);
  if (before <= 0) return enter;
  for (size_t i = 1; i < crossings.size(); ++i) {
    const double after = over(crossings[i]);
    if (after <= 0)
      return crossings[i - 1] + (crossings[i] - crossings[i - 1]) * (before / (before - after));
    before = after;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace openr_host
