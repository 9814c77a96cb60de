// Triangles of a box with rounded edges.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace openr_host::render {

struct Vertex {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;  // unit length
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<uint32_t> triangles;  // three indices each, counterclockwise from outside
};

// Returns a box centred on the origin, with edges along the axes.  `radius` is reduced to half of
// the shortest edge if it is larger.  `steps` >= 1 is the number of segments for a quarter circle.
Mesh RoundedBox(const Eigen::Vector3f& size, float radius, int steps);

}  // namespace openr_host::render
