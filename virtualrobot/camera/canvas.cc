#include "virtualrobot/camera/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "runtime/base/assert.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Number of steps of brightness from the shadow to the lit side of a ball.
constexpr int kSteps = 63;

// Returns the index of the first pixel with its centre beyond the coordinate `x`, along an axis
// with `size` pixels; `size` if there is no such pixel.
int FirstBeyond(double x, double size) { return static_cast<int>(std::clamp(x + 0.5, 0.0, size)); }

void PutPixel(const RgbBytes& colour, uint8_t* pixel) {
  pixel[0] = colour[0];
  pixel[1] = colour[1];
  pixel[2] = colour[2];
}

void FillPixels(const RgbBytes& colour, int count, uint8_t* pixel) {
  for (int i = 0; i < count; ++i) PutPixel(colour, pixel + 3 * i);
}

}  // namespace

RgbBytes RgbOf(const Vector3d& colour, double brightness) {
  RgbBytes bytes;
  for (size_t i = 0; i < 3; ++i) {
    const double level = colour[static_cast<int>(i)] * brightness * 255 + 0.5;
    bytes[i] = static_cast<uint8_t>(std::clamp(level, 0.0, 255.0));
  }
  return bytes;
}

void Face::CutBy(const Vector3d& normal, double offset) {
  const auto height = [&](const Vector3d& p) { return normal.dot(p) + offset; };
  bool is_cut = false;
  for (int i = 0; i < count_ && !is_cut; ++i) is_cut = height(corner(i)) < 0;
  if (!is_cut) return;
  const Face whole = *this;
  Clear();
  for (int i = 0; i < whole.count(); ++i) {
    const Vector3d& from = whole.corner(i);
    const Vector3d& to = whole.corner(i + 1 < whole.count() ? i + 1 : 0);
    const double a = height(from), b = height(to);
    if (a >= 0) Add(from);
    if ((a >= 0) == (b >= 0)) continue;
    // Adds the point at which the plane cuts the edge.  Computes the point always from the same end
    // of the edge, the end that is not cut off.  Two faces have this edge and may list its ends in
    // opposite order, but must get the same corner.
    Add(a >= 0 ? from + (to - from) * (a / (a - b)) : to + (from - to) * (b / (b - a)));
  }
}

void Canvas::Begin(const CameraShot& shot, const RgbBytes& floor, const RgbBytes& background,
                   Picture* picture) {
  picture_ = picture;
  width_ = picture->width;
  height_ = picture->height;
  R_CW_ = shot.X_WC.linear().transpose();
  p_WC_ = shot.X_WC.translation();
  slope_h_ = DetSin(shot.fov_h_rad / 2) / DetCos(shot.fov_h_rad / 2);
  slope_v_ = DetSin(shot.fov_v_rad / 2) / DetCos(shot.fov_v_rad / 2);
  inverse_depth_.assign(static_cast<size_t>(width_) * static_cast<size_t>(height_), 0);
  x_.resize(static_cast<size_t>(height_));

  // Fills each pixel with the colour of the floor or of the background.  If `rise` of a pixel is
  // negative, the ray of the pixel goes down and meets the floor.
  const Linear rise = AlongRays(R_CW_.col(2));
  std::vector<uint8_t> rows[2];
  for (const bool is_floor : {false, true}) {
    std::vector<uint8_t>& row = rows[is_floor ? 1 : 0];
    row.resize(static_cast<size_t>(width_) * 3);
    FillPixels(is_floor ? floor : background, width_, row.data());
  }
  const auto is_floor = [&](int x, int y) { return rise.Of(x + 0.5, y + 0.5) < 0; };
  for (int y = 0; y < height_; ++y) {
    const bool left = is_floor(0, y), right = is_floor(width_ - 1, y);
    std::memcpy(Row(y), rows[left ? 1 : 0].data(), rows[0].size());
    if (left == right) continue;
    int x = 0;
    while (is_floor(x, y) == left) ++x;
    FillPixels(right ? floor : background, width_ - x, Row(y) + 3 * x);
  }
}

Canvas::Linear Canvas::AlongRays(const Vector3d& v) const {
  // The ray through the point (x, y) of the picture has the direction (1, slope_h (1 - 2 x /
  // width), slope_v (1 - 2 y / height)).  Here, slope_h and slope_v are the slopes of the rays at
  // the left and the upper edge.  So the scalar product of this direction with `v` is linear in x
  // and y.  Returns the constant and the factors of x and y.
  return {v.x() + v.y() * slope_h_ + v.z() * slope_v_, -2 * v.y() * slope_h_ / width_,
          -2 * v.z() * slope_v_ / height_};
}

bool Canvas::MaySee(const Vector3d& centre_W, double radius_m) const {
  const Vector3d p = R_CW_ * (centre_W - p_WC_);
  if (p.x() + radius_m < kNear_m) return false;
  // Returns whether the ball is completely outside the plane through the lens and an edge of the
  // picture, so that no part of the ball is in the picture.
  const auto is_outside = [&](double sideways, double slope) {
    return std::fabs(sideways) - p.x() * slope > radius_m * std::sqrt(1 + slope * slope);
  };
  return !is_outside(p.y(), slope_h_) && !is_outside(p.z(), slope_v_);
}

Face Canvas::InLens(const Face& face) const {
  Face in_lens;
  for (int i = 0; i < face.count(); ++i) in_lens.Add(R_CW_ * (face.corner(i) - p_WC_));
  in_lens.CutBy(Vector3d::UnitX(), -kNear_m);
  return in_lens;
}

void Canvas::AddEdge(const Vector2d& from, const Vector2d& to) {
  // Follows the edge from its upper to its lower end, so that two faces that share the edge get the
  // same pixels.
  const bool is_down = from.y() < to.y() || (from.y() == to.y() && from.x() < to.x());
  const Vector2d &top = is_down ? from : to, &bottom = is_down ? to : from;
  const int begin = FirstBeyond(top.y(), height_), end = FirstBeyond(bottom.y(), height_);
  if (begin >= end) return;
  const double step = (bottom.x() - top.x()) / (bottom.y() - top.y());
  for (int y = begin; y < end; ++y) {
    const double x = top.x() + (y + 0.5 - top.y()) * step;
    std::array<double, 2>& row = x_[static_cast<size_t>(y)];
    row[0] = std::min(row[0], x);
    row[1] = std::max(row[1], x);
  }
}

Canvas::Span Canvas::FindSpans(const Face& face) {
  std::array<Vector2d, Face::kCornersMax + 2> points;
  double top = height_, bottom = 0;
  for (int i = 0; i < face.count(); ++i) {
    const Vector3d& p = face.corner(i);
    Vector2d& point = points[static_cast<size_t>(i)];
    point.x() = width_ * 0.5 * (1 - p.y() / (p.x() * slope_h_));
    point.y() = height_ * 0.5 * (1 - p.z() / (p.x() * slope_v_));
    top = std::min(top, point.y());
    bottom = std::max(bottom, point.y());
  }
  const Span rows{FirstBeyond(top, height_), FirstBeyond(bottom, height_)};
  // Begins each row with an empty range, because the edges of the face only widen this range.
  const std::array<double, 2> nothing{static_cast<double>(width_), 0};
  for (int y = rows.begin; y < rows.end; ++y) x_[static_cast<size_t>(y)] = nothing;
  for (int i = 0; i < face.count(); ++i) {
    const int next = i + 1 < face.count() ? i + 1 : 0;
    AddEdge(points[static_cast<size_t>(i)], points[static_cast<size_t>(next)]);
  }
  return rows;
}

void Canvas::DrawPaint(Face face, const RgbBytes& colour) {
  // Draws no paint if the lens is below the floor, because the floor hides the upper side of the
  // paint.
  if (p_WC_.z() <= 0) return;
  const Face in_lens = InLens(face);
  if (in_lens.count() < 3) return;
  const Span rows = FindSpans(in_lens);
  for (int y = rows.begin; y < rows.end; ++y) {
    const auto& [left, right] = x_[static_cast<size_t>(y)];
    const int begin = FirstBeyond(left, width_), end = FirstBeyond(right, width_);
    if (begin < end) FillPixels(colour, end - begin, Row(y) + 3 * begin);
  }
}

void Canvas::DrawFace(Face face, const Vector3d& normal_W, const RgbBytes& colour) {
  ASSERT(face.count() >= 3 && face.count() <= Face::kCornersMax, "{} corners", face.count());
  // In the axes of the camera's frame C, the face lies in the plane of all p with n . p = height.
  // The height is negative if the lens sees the front of the face.
  const Vector3d n = R_CW_ * normal_W;
  const double height = normal_W.dot(face.corner(0) - p_WC_);
  if (!(height < 0)) return;
  // Cuts away the part of the face below the floor, because the depth buffer has no depths of the
  // floor, so the floor could not hide this part.
  face.CutBy(Vector3d::UnitZ(), 0);
  const Face in_lens = InLens(face);
  if (in_lens.count() < 3) return;
  const Linear inverse = AlongRays(n / height);
  const Span rows = FindSpans(in_lens);
  for (int y = rows.begin; y < rows.end; ++y) {
    const auto& [left, right] = x_[static_cast<size_t>(y)];
    const int end = FirstBeyond(right, width_);
    const double at_row = inverse.Of(0, y + 0.5);
    float* const depths = DepthRow(y);
    uint8_t* const pixels = Row(y);
    for (int x = FirstBeyond(left, width_); x < end; ++x) {
      const auto depth = static_cast<float>(at_row + (x + 0.5) * inverse.along_x);
      if (depth <= depths[x]) continue;
      depths[x] = depth;
      PutPixel(colour, pixels + 3 * x);
    }
  }
}

Canvas::Span Canvas::SpanOfBall(double forward, double sideways, double radius_m,
                                double pixels_per_slope, double size) const {
  // In the plane of `forward` and `sideways`, the ball is a circle.  Its centre is as far as the
  // radius from each of its two tangents through the lens.  So the slopes m of the tangents solve
  // (sideways - m forward)^2 = radius^2 (1 + m^2).
  const double a = forward * forward - radius_m * radius_m;
  const double root = a + sideways * sideways;
  if (forward <= radius_m || a <= 0 || root <= 0) return {0, static_cast<int>(size)};
  const double middle = forward * sideways, half = radius_m * std::sqrt(root);
  const double low = (middle - half) / a, high = (middle + half) / a;
  // The greater slope `high` gives the first pixel, because slopes grow to the left and upwards,
  // but pixels are numbered to the right and downwards.
  return {FirstBeyond(size * 0.5 - high * pixels_per_slope - 1, size),
          FirstBeyond(size * 0.5 - low * pixels_per_slope + 1, size)};
}

void Canvas::DrawBall(const Vector3d& centre_W, double radius_m, const Vector3d& colour,
                      const Vector3d& to_light_W, double ambient) {
  const Vector3d centre = R_CW_ * (centre_W - p_WC_), to_light = R_CW_ * to_light_W;
  // The ray from the lens in the direction d meets the ball at the point t d whose distance from
  // the centre is the radius: a t^2 - 2 b t + c = 0, where a is d . d, b is d . centre, and c is
  // centre . centre - radius^2.  Of its two solutions, the nearer point has 1 / t = (b + sqrt(b^2 -
  // a c)) / c.
  const double c = centre.squaredNorm() - radius_m * radius_m;
  if (c <= 0) return;
  const Span columns =
      SpanOfBall(centre.x(), centre.y(), radius_m, width_ / (2 * slope_h_), width_);
  const Span rows = SpanOfBall(centre.x(), centre.z(), radius_m, height_ / (2 * slope_v_), height_);
  const Linear towards = AlongRays(centre), left = AlongRays(Vector3d::UnitY());
  const Linear up = AlongRays(Vector3d::UnitZ()), rise = AlongRays(R_CW_.col(2));
  // At the point t d, where the ray meets the ball, the outward normal of the ball is (t d -
  // centre) / radius.  The share of the directed light at this point is the scalar product of the
  // normal with the direction to the light.  That is t * light(d) - light_of_centre, where light(d)
  // is (to_light . d) / radius and light_of_centre is (to_light . centre) / radius.
  const Linear light = AlongRays(to_light / radius_m);
  const double light_of_centre = to_light.dot(centre) / radius_m, per_c = 1 / c;
  const bool is_sunk = centre_W.z() < radius_m;
  std::array<RgbBytes, kSteps + 1> shades;
  for (size_t i = 0; i < shades.size(); ++i)
    shades[i] = RgbOf(colour, ambient + (1 - ambient) * static_cast<double>(i) / kSteps);

  for (int y = rows.begin; y < rows.end; ++y) {
    float* const depths = DepthRow(y);
    uint8_t* const pixels = Row(y);
    const double py = y + 0.5, up_slope = up.Of(0, py);
    for (int x = columns.begin; x < columns.end; ++x) {
      const double px = x + 0.5, left_slope = left.Of(px, 0), b = towards.Of(px, py);
      const double a = 1 + left_slope * left_slope + up_slope * up_slope;
      const double square = b * b - a * c;
      if (square < 0 || b <= 0) continue;
      const double inverse = (b + std::sqrt(square)) * per_c;
      const auto depth = static_cast<float>(inverse);
      if (depth <= depths[x] || inverse * kNear_m > 1) continue;
      // Does not draw a point that is under the floor.  The sum in this condition is the height of
      // the point over the floor, divided by its distance from the lens along the optical axis.
      if (is_sunk && p_WC_.z() * inverse + rise.Of(px, py) < 0) continue;
      depths[x] = depth;
      const double share = std::clamp(light.Of(px, py) / inverse - light_of_centre, 0.0, 1.0);
      PutPixel(shades[static_cast<size_t>(static_cast<int>(share * kSteps + 0.5))], pixels + 3 * x);
    }
  }
}

}  // namespace openr_host
