// Scene, a picture to be drawn, as plain data: shapes with places and colours, and a camera.
//
// Coordinates are those of the world W: metres, right-handed, z up, the floor at z = 0.  Scenes
// know nothing of robots.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace openr_host::render {

struct Colour {
  // Red, green and blue, each from 0 to 1, as seen on a screen (sRGB).
  float r = 0.5f, g = 0.5f, b = 0.5f;
};

// A box with rounded edges.  It is a ball when `radius_m` is half of each edge.
struct Shape {
  Eigen::Isometry3d X_WS = Eigen::Isometry3d::Identity();  // centre and axes of the box in W
  Eigen::Vector3d size_m{0, 0, 0};                         // lengths of the box's edges
  // Radius of the edges.  If the radius is larger than half of the shortest edge, half of the
  // shortest edge is used instead.
  double radius_m = 0;
  bool is_cylinder = false;  // true: a cylinder along z fills the box; its edges are sharp
  // Three corners for each triangle of a surface, counterclockwise from outside, in the axes of the
  // box.  If there are triangles, they are drawn instead of the box.
  std::vector<Eigen::Vector3f> triangles;
  Colour colour;
  float gloss = 0.3f;  // gloss of the surface, from 0 (dull) to 1 (polished)
  bool glows = false;  // true: the shape shines in its own colour, even in the shadow
};

struct Camera {
  Eigen::Vector3d p_W{1, -1, 0.5};  // place of the camera in the world
  Eigen::Vector3d target_W{0, 0, 0};
  // Direction that is up in the picture; must not be parallel to the line of sight.
  Eigen::Vector3d up{0, 0, 1};
  double fov_rad = 0.5;         // angle of view from the bottom to the top of the picture
  double shadow_reach_m = 0.4;  // shadows are drawn only up to this distance from `target_W`
};

struct Scene {
  std::vector<Shape> shapes;
  Camera camera;
  double floor_grid_m = 0.1;  // distance of the lines on the floor
  Colour floor{0.83f, 0.84f, 0.85f};
};

struct Picture {
  int width_px = 1280;  // width in pixels, 16 to 4096
  int height_px = 720;  // height in pixels, 16 to 4096
};

// The type of openr_render_picture(), which the program finds in libopenr_render.so by its name.
// The function sets `png` to the bytes of a PNG file, or `error` to the error.
using RenderPicture = void(const Scene& scene, const Picture& picture, std::string* png,
                           std::string* error);
constexpr char kRenderPictureName[] = "openr_render_picture";

}  // namespace openr_host::render
