// Makes the triangles of boxes with rounded edges, of cylinders and of surfaces.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace openr_host::render {

struct Vertex {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;  // direction of the surface at this vertex, of unit length
};

struct Mesh {
  std::vector<Vertex> vertices;
  // Three indices of `vertices` per triangle; counterclockwise, seen from outside.
  std::vector<uint32_t> triangles;
};

// Returns a box whose centre is the origin.  `radius` is the radius of its edges, at most half of
// its shortest edge.  `steps` is the number of segments in a quarter circle, at least 1.
Mesh RoundedBox(const Eigen::Vector3f& size, float radius, int steps);

// Returns a cylinder along z that fills a box of the size `size` around the origin.  `sides` is the
// number of its side faces, at least 3.
Mesh Cylinder(const Eigen::Vector3f& size, int sides);

// Returns a mesh of flat triangles.  The first three points of `corners` are the corners of the
// first triangle, the next three points are the corners of the second triangle, and so on.
Mesh Surface(const std::vector<Eigen::Vector3f>& corners);

}  // namespace openr_host::render
