// Canvas: a picture with a depth buffer, on which faces and balls are drawn as a lens sees them.
//
// Because the pictures are part of a run, they have the same bits on every machine: the code uses
// doubles with + - * / and sqrt only, and det_math.h for the angle of view (docs/worlds.md,
// Camera).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/base/assert.h"
#include "virtualrobot/camera/image_source.h"

namespace openr_host {

using RgbBytes = std::array<uint8_t, 3>;

// Returns the bytes of `colour` (red, green and blue, 0 to 1) in light of `brightness` (0 to 1).
RgbBytes RgbOf(const Eigen::Vector3d& colour, double brightness);

// A convex polygon.  Its corners are in the world frame W; the canvas converts them to the frame C
// of the lens.
class Face {
 public:
  static constexpr int kCornersMax = 32;

  void Clear() { count_ = 0; }
  // Adds a corner to the face.  REQUIRES: count() < kCornersMax + 2.
  void Add(const Eigen::Vector3d& corner) {
    ASSERT(count_ < kCornersMax + 2, "a face has {} corners", count_);
    corners_[static_cast<size_t>(count_++)] = corner;
  }
  int count() const { return count_; }
  const Eigen::Vector3d& corner(int i) const { return corners_[static_cast<size_t>(i)]; }

  // Removes the part of the face whose points p have normal . p + offset < 0.  The rest of the face
  // has at most one corner more.
  void CutBy(const Eigen::Vector3d& normal, double offset);

 private:
  int count_ = 0;
  // The corners of the face.  There is room for one more corner for each of the two planes by which
  // the canvas cuts a face.
  std::array<Eigen::Vector3d, kCornersMax + 2> corners_;
};

class Canvas {
 public:
  // Things nearer than this distance along the optical axis are not drawn, because the drawing
  // functions divide by the distance.
  static constexpr double kNear_m = 0.004;

  // Begins a picture: draws the floor z = 0 up to the horizon, and the background above it.
  // `picture` must exist until its things are drawn.
  void Begin(const CameraShot& shot, const RgbBytes& floor, const RgbBytes& background,
             Picture* picture);

  // Returns whether a ball with this centre and radius could be in the picture.  If the ball around
  // a thing is not in the picture, the thing need not be drawn.
  bool MaySee(const Eigen::Vector3d& centre_W, double radius_m) const;

  // Draws a face whose front side has the outward normal `normal_W`; its back side is not drawn.
  // The part of the face below the floor is cut away.
  void DrawFace(Face face, const Eigen::Vector3d& normal_W, const RgbBytes& colour);

  // Draws paint, a face on the floor.  REQUIRES: called before faces and balls are drawn, because
  // paint has no depth and would cover them.
  void DrawPaint(Face face, const RgbBytes& colour);

  // Draws a ball that is lit from the direction `to_light_W`.  `ambient` is the share of the light
  // that comes from all directions, 0 to 1.
  void DrawBall(const Eigen::Vector3d& centre_W, double radius_m, const Eigen::Vector3d& colour,
                const Eigen::Vector3d& to_light_W, double ambient);

  // Returns the place of the lens in the world W.
  const Eigen::Vector3d& p_WC() const { return p_WC_; }

 private:
  // A quantity that is linear in the coordinates of the picture: at + x * along_x + y * along_y.
  struct Linear {
    double at = 0, along_x = 0, along_y = 0;
    double Of(double x, double y) const { return at + x * along_x + y * along_y; }
  };
  // A range of pixels of a row, or a range of rows: from `begin` to `end` - 1.
  struct Span {
    int begin = 0, end = 0;
  };

  // Returns, as a function of the pixel, the product v . d: d is the direction of the ray through
  // the pixel, in the frame C of the lens, with d.x = 1.
  Linear AlongRays(const Eigen::Vector3d& v) const;
  // Stores in x_ where the face begins and ends in each row of pixels, and returns the rows that
  // the face reaches.  REQUIRES: the corners of the face are in the frame C of the lens.
  Span FindSpans(const Face& face);
  void AddEdge(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  // Returns a range of pixels along one axis of the picture, which has `size` pixels.  Only pixels
  // in this range can show the ball.  The centre of the ball is at `forward` along the x axis of
  // the lens, and at `sideways` along the y axis (for a range of columns) or the z axis (for a
  // range of rows).  `pixels_per_slope` is the number of pixels by which a point moves in the
  // picture when sideways / forward grows by 1.
  Span SpanOfBall(double forward, double sideways, double radius_m, double pixels_per_slope,
                  double size) const;
  Face InLens(const Face& face) const;
  uint8_t* Row(int y) { return picture_->At(0, y); }
  float* DepthRow(int y) {
    return &inverse_depth_[static_cast<size_t>(y) * static_cast<size_t>(width_)];
  }

  Picture* picture_ = nullptr;
  int width_ = 0, height_ = 0;
  Eigen::Matrix3d R_CW_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p_WC_{0, 0, 0};
  double slope_h_ = 1, slope_v_ = 1;  // slopes of the rays at the picture's left and upper edge
  // For each pixel, 1 divided by the distance of the drawn point from the lens along the optical
  // axis, so a nearer point has a greater value; 0 where only floor or background is drawn.
  std::vector<float> inverse_depth_;
  std::vector<std::array<double, 2>> x_;  // for each row: the least and the greatest x of a face
};

}  // namespace openr_host
