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

// Centred on the origin, edges along the axes; `radius` is cut to half of the shortest edge.
// `steps` >= 1 segments round a quarter of an edge.
Mesh RoundedBox(const Eigen::Vector3f& size, float radius, int steps);

}  // namespace openr_host::render
