#include "leg.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "virtualrobot/base/det_math.h"

namespace openr_host::motions {
namespace {

// Rotates a point about the origin.  A positive angle moves a paw that hangs down outward.
LegPoint Turn(const LegPoint& p, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {p.out * c - p.up * s, p.out * s + p.up * c};
}

double Direction(const LegPoint& p) { return std::atan2(p.up, p.out); }
double Length(const LegPoint& p) { return std::hypot(p.out, p.up); }

}  // namespace

LegPoint Leg::Paw(const LegAngles& angles) const {
  const LegPoint shin = Turn(paw_, angles.j3_rad);
  return Turn({knee_.out + shin.out, knee_.up + shin.up}, angles.j1_rad);
}

LegAngles Leg::Reach(const LegPoint& target, const std::string& what) const {
  const double thigh = Length(knee_), shin = Length(paw_), far = Length(target);
  // Computes the angle between thigh and shin by the law of cosines; it is 0 when the leg is
  // stretched.
  const double cosine = (far * far - thigh * thigh - shin * shin) / (2 * thigh * shin);
  if (cosine > 1 || cosine < -1) {
    throw std::domain_error(fmt::format(
        "{}: the paw cannot reach {:.1f} mm out, {:.1f} mm up; the leg is {:.1f} mm long", what,
        target.out, target.up, thigh + shin));
  }
  LegAngles angles;
  angles.j3_rad = std::acos(cosine) - (Direction(paw_) - Direction(knee_));
  const LegPoint bent = Paw({0, angles.j3_rad});
  angles.j1_rad = std::remainder(Direction(target) - Direction(bent), 2 * kPi);
  return angles;
}

}  // namespace openr_host::motions
