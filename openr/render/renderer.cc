#include "openr/render/renderer.h"

#include <GL/osmesa.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "openr/render/gl_program.h"
#include "openr/render/mesh.h"
#include "openr/render/shaders.h"
#include "openr/render/view_matrices.h"

namespace openr_host::render {
namespace {

constexpr int kOversample = 3;  // drawn pixels per pixel of the picture, in each direction
constexpr int kEdgeSteps = 8;   // number of segments in a quarter circle at the edges of shapes
constexpr int kCylinderSides = 48;
constexpr int kShadowPixels = 2048;
constexpr double kFloorHalfM = 6;
const Eigen::Vector3f kBackground(0.93f, 0.94f, 0.95f);
const Eigen::Vector3d kToSun = Eigen::Vector3d(0.35, -0.55, 1.0).normalized();

// An OpenGL context of Mesa that draws into memory.  While an OffScreen exists, OpenGL uses this
// context.
class OffScreen {
 public:
  OffScreen(int width, int height)
      : pixels_(size_t{4} * static_cast<size_t>(width) * static_cast<size_t>(height)),
        context_(OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr)) {
    if (context_ == nullptr ||
        OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width, height) == GL_FALSE) {
      throw std::runtime_error("Mesa cannot make a picture of this size in memory");
    }
  }
  ~OffScreen() { OSMesaDestroyContext(context_); }
  OffScreen(const OffScreen&) = delete;
  OffScreen& operator=(const OffScreen&) = delete;

  // Returns the drawn pixels: four bytes each (RGBA), row by row, the bottom row first.
  const std::vector<uint8_t>& pixels() const { return pixels_; }

 private:
  std::vector<uint8_t> pixels_;
  OSMesaContext context_;
};

struct Item {
  Mesh mesh;
  Eigen::Matrix4f world_from_shape;
  const Shape* shape;
};

Mesh MeshOf(const Shape& shape) {
  const Eigen::Vector3f size = shape.size_m.cast<float>();
  if (!shape.triangles.empty()) return Surface(shape.triangles);
  if (shape.is_cylinder) return Cylinder(size, kCylinderSides);
  return RoundedBox(size, static_cast<float>(shape.radius_m), kEdgeSteps);
}

std::vector<Item> MakeItems(const Scene& scene) {
  std::vector<Item> items;
  for (const Shape& shape : scene.shapes)
    items.push_back({MeshOf(shape), shape.X_WS.matrix().cast<float>(), &shape});
  return items;
}

void DrawMesh(const Mesh& mesh) {
  glVertexPointer(3, GL_FLOAT, sizeof(Vertex), mesh.vertices[0].position.data());
  glNormalPointer(GL_FLOAT, sizeof(Vertex), mesh.vertices[0].normal.data());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.triangles.size()), GL_UNSIGNED_INT,
                 mesh.triangles.data());
}

void DrawDepths(const std::vector<Item>& items, const Eigen::Matrix4f& light_from_world,
                const GlProgram& program, const DepthTarget& target) {
  target.Bind();
  program.Use();
  program.Set("light_from_world", light_from_world);
  for (const Item& item : items) {
    program.Set("world_from_shape", item.world_from_shape);
    DrawMesh(item.mesh);
  }
}

void SetMaterial(const GlProgram& program, const Colour& colour, float gloss, bool glows) {
  program.Set("colour", Eigen::Vector3f(colour.r, colour.g, colour.b));
  program.Set("gloss", gloss);
  program.Set("glow", glows ? 1.0f : 0.0f);
}

void DrawFloor(const GlProgram& program, const Scene& scene) {
  Mesh floor;
  const Eigen::Vector3f up(0, 0, 1);
  const auto half = static_cast<float>(kFloorHalfM);
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    floor.vertices.push_back({{half * static_cast<float>(x), half * static_cast<float>(y), 0}, up});
  }
  floor.triangles = {0, 1, 2, 0, 2, 3};
  Eigen::Matrix4f place = Eigen::Matrix4f::Identity();
  place.block<2, 1>(0, 3) = scene.camera.target_W.head<2>().cast<float>();
  program.Set("world_from_shape", place);
  program.Set("grid", static_cast<float>(scene.floor_grid_m));
  SetMaterial(program, scene.floor, 0.0f, false);
  DrawMesh(floor);
  program.Set("grid", 0.0f);
}

void BindDepth(int unit, const DepthTarget& target) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, target.texture());
}

// Returns the picture in its final size: each pixel is the average of kOversample x kOversample
// drawn pixels.
std::vector<uint8_t> Shrink(const std::vector<uint8_t>& rgba, int width, int height) {
  std::vector<uint8_t> rgb;
  rgb.reserve(size_t{3} * static_cast<size_t>(width) * static_cast<size_t>(height));
  const int wide = width * kOversample;
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      int sum[3] = {0, 0, 0};
      for (int i = 0; i < kOversample * kOversample; ++i) {
        const int row = y * kOversample + i / kOversample;
        const int column = x * kOversample + i % kOversample;
        const uint8_t* const pixel =
            &rgba[4 * (static_cast<size_t>(row) * static_cast<size_t>(wide) +
                       static_cast<size_t>(column))];
        for (int c = 0; c < 3; ++c) sum[c] += pixel[c];
      }
      for (const int s : sum) {
        rgb.push_back(static_cast<uint8_t>((s + kOversample * kOversample / 2) /
                                           (kOversample * kOversample)));
      }
    }
  }
  return rgb;
}

}  // namespace

std::vector<uint8_t> Draw(const Scene& scene, int width_px, int height_px) {
  const int width = width_px * kOversample, height = height_px * kOversample;
  const OffScreen screen(width, height);
  const GlProgram depth_program(kDepthVertexShader, kDepthFragmentShader);
  const GlProgram program(kPictureVertexShader, kPictureFragmentShader);
  const DepthTarget sun_depth(kShadowPixels), sky_depth(kShadowPixels);
  const Camera& camera = scene.camera;
  const std::vector<Item> items = MakeItems(scene);
  const Eigen::Matrix4f sun = LightMatrix(camera.target_W, kToSun, camera.shadow_reach_m);
  const Eigen::Matrix4f sky =
      LightMatrix(camera.target_W, Eigen::Vector3d::UnitZ(), camera.shadow_reach_m);

  glEnable(GL_DEPTH_TEST);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  // Draws in two passes.  The first pass draws the distance of surfaces from two lights: the sun,
  // and the sky straight above.  The second pass draws the picture; a point is in shadow if another
  // surface is nearer to the light.
  DrawDepths(items, sun, depth_program, sun_depth);
  DrawDepths(items, sky, depth_program, sky_depth);

  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  glClearColor(kBackground.x(), kBackground.y(), kBackground.z(), 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_CULL_FACE);
  program.Use();
  BindDepth(0, sun_depth);
  BindDepth(1, sky_depth);
  program.Set("sun_depth", 0);
  program.Set("sky_depth", 1);
  program.Set("picture_from_world",
              CameraMatrix(camera, static_cast<double>(width_px) / height_px));
  program.Set("sun_from_world", sun);
  program.Set("sky_from_world", sky);
  program.Set("eye", Eigen::Vector3f(camera.p_W.cast<float>()));
  program.Set("centre", Eigen::Vector3f(camera.target_W.cast<float>()));
  program.Set("to_sun", Eigen::Vector3f(kToSun.cast<float>()));
  program.Set("background", kBackground);
  program.Set("softness", static_cast<float>(Camera().shadow_reach_m / camera.shadow_reach_m));
  program.Set("reach", static_cast<float>(3 * (camera.p_W - camera.target_W).norm()));
  DrawFloor(program, scene);
  for (const Item& item : items) {
    program.Set("world_from_shape", item.world_from_shape);
    SetMaterial(program, item.shape->colour, item.shape->gloss, item.shape->glows);
    DrawMesh(item.mesh);
  }
  glFinish();
  return Shrink(screen.pixels(), width_px, height_px);
}

}  // namespace openr_host::render
