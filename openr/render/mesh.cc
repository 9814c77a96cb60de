#include "openr/render/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace openr_host::render {
namespace {

// Adds one of the six sides of a rounded box to `mesh`, as a square grid of points.  `axis` (0 to
// 2: x to z) and `sign` (1 or -1) give the direction in which the side faces.  `flat` is half the
// size of the box along each axis, minus `radius`.  The grid has 2 * (`steps` + 1) lines in each
// direction.  The first half of these lines is on the round edge at one end of the side, and the
// second half on the round edge at the opposite end.  Between the halves is the flat part.
void AddSide(int axis, float sign, const Eigen::Vector3f& flat, float radius, int steps,
             Mesh* mesh) {
  const int u_axis = (axis + 1) % 3;
  const int v_axis = (axis + 2) % 3;
  const int per_line = 2 * (steps + 1);
  // Returns the tangent of the angle by which the surface is turned at line `i` of the grid, away
  // from the direction in which this side of the box faces.  The angles go from -45 to 45 degrees
  // in equal steps, so that the edges are evenly round.
  const auto slope = [steps](int i) {
    // The lines `steps` and `steps` + 1 of the grid lie at the two borders of the flat part, and
    // both have the angle 0.  So `step` goes from -steps to 0, and then from 0 to steps.
    const int step = i <= steps ? i - steps : i - steps - 1;
    return std::tan(static_cast<float>(step) / static_cast<float>(steps) * 0.78539816f);
  };
  const auto half = [steps](int i) { return i <= steps ? -1.0f : 1.0f; };

  const auto first = static_cast<uint32_t>(mesh->vertices.size());
  for (int i = 0; i < per_line; ++i) {
    for (int j = 0; j < per_line; ++j) {
      Eigen::Vector3f normal;
      normal[axis] = sign;
      normal[u_axis] = slope(i);
      normal[v_axis] = slope(j);
      normal.normalize();
      Eigen::Vector3f corner;
      corner[axis] = sign * flat[axis];
      corner[u_axis] = half(i) * flat[u_axis];
      corner[v_axis] = half(j) * flat[v_axis];
      mesh->vertices.push_back({corner + radius * normal, normal});
    }
  }
  const auto at = [&](int i, int j) { return first + static_cast<uint32_t>(i * per_line + j); };
  for (int i = 0; i + 1 < per_line; ++i) {
    for (int j = 0; j + 1 < per_line; ++j) {
      uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (sign < 0) std::swap(b, d);
      for (const uint32_t index : {a, b, c, a, c, d}) mesh->triangles.push_back(index);
    }
  }
}

}  // namespace

Mesh RoundedBox(const Eigen::Vector3f& size, float radius, int steps) {
  radius = std::clamp(radius, 0.0f, 0.5f * size.minCoeff());
  const Eigen::Vector3f flat = 0.5f * size - Eigen::Vector3f::Constant(radius);
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    AddSide(axis, 1, flat, radius, steps, &mesh);
    AddSide(axis, -1, flat, radius, steps, &mesh);
  }
  return mesh;
}

// Makes two triangles for each side face of the cylinder, and `sides` - 2 triangles at each of the
// two ends.
Mesh Cylinder(const Eigen::Vector3f& size, int sides) {
  Mesh mesh;
  const Eigen::Vector3f half = 0.5f * size;
  // Adds a circle of vertices of the cylinder.  The side face and the two ends need circles of
  // their own, because the normals at their vertices differ.
  const auto add_circle = [&](float end, bool is_side) {
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (int i = 0; i < sides; ++i) {
      const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(sides);
      const Eigen::Vector3f out(std::cos(angle), std::sin(angle), 0);
      mesh.vertices.push_back({{half.x() * out.x(), half.y() * out.y(), end * half.z()},
                               is_side ? out : Eigen::Vector3f(0, 0, end)});
    }
    return first;
  };
  const uint32_t low = add_circle(-1, true), high = add_circle(1, true);
  const uint32_t bottom = add_circle(-1, false), top = add_circle(1, false);
  const auto n = static_cast<uint32_t>(sides);
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t next = (i + 1) % n;
    for (const uint32_t index : {low + i, low + next, high + next, low + i, high + next, high + i})
      mesh.triangles.push_back(index);
    if (i == 0 || next == 0) continue;
    for (const uint32_t index : {top, top + i, top + next, bottom, bottom + next, bottom + i})
      mesh.triangles.push_back(index);
  }
  return mesh;
}

Mesh Surface(const std::vector<Eigen::Vector3f>& corners) {
  Mesh mesh;
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Eigen::Vector3f normal =
        (corners[i + 1] - corners[i]).cross(corners[i + 2] - corners[i]).normalized();
    for (size_t corner = i; corner < i + 3; ++corner) {
      mesh.triangles.push_back(static_cast<uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back({corners[corner], normal});
    }
  }
  return mesh;
}

}  // namespace openr_host::render
