#include "virtualrobot/body/stiff_robot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "runtime/base/assert.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/rotation.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Distance below which a paw counts as touching the floor.  In all standing postures of the
// ERS-210, the lower ends of the four paws are less than 0.1 mm away from a common plane, so all
// four paws touch the floor.
constexpr double kTouch_m = 0.0005;

// Returns the rotation R_WB with yaw 0 whose third row is `up_B`, the upward direction of the world
// W in the axes of the robot's base frame B.
Matrix3d LevelRotation(const Vector3d& up_B) {
  const double sp = -up_B.x();
  const double cp = std::sqrt(std::max(0.0, 1 - sp * sp));
  if (cp < 1e-9) return AxisRotation(Vector3d::UnitY(), sp > 0 ? kPi / 2 : -kPi / 2);
  const double sr = up_B.y() / cp, cr = up_B.z() / cp;
  Matrix3d R;
  R << cp, sp * sr, sp * cr,  //
      0, cr, -sr,             //
      -sp, cp * sr, cp * cr;
  return R;
}

using Triangle = std::array<Vector3d, 3>;  // three corners, counterclockwise when seen from above

double Cross2(const Vector3d& o, const Vector3d& p, const Vector3d& q) {
  return (p.x() - o.x()) * (q.y() - o.y()) - (p.y() - o.y()) * (q.x() - o.x());
}

// Returns whether the point `p` is inside the triangle `t`, seen from above.
bool IsInsideFromAbove(const Triangle& t, const Vector3d& p) {
  return Cross2(t[0], t[1], p) >= 0 && Cross2(t[1], t[2], p) >= 0 && Cross2(t[2], t[0], p) >= 0;
}

struct Plane {  // the plane of all points with z = a x + b y + c
  double a, b, c;
};

Plane Through(const Triangle& t) {
  const Vector3d n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double a = -n.x() / n.z(), b = -n.y() / n.z();
  return {a, b, t[0].z() - a * t[0].x() - b * t[0].y()};
}

Triangle HugeTriangleOver(const Vector3d& centre) {
  const Vector3d o(centre.x(), centre.y(), 10);
  return {o + Vector3d(10, 0, 0), o + Vector3d(-5, 8, 0), o + Vector3d(-5, -8, 0)};
}

// Turns the triangle `t` into the face of the robot's convex hull that lies below `centre`.  Each
// pass replaces one corner by the point of the hull that is furthest below the plane of the
// triangle.  The corner is chosen so that `centre` stays inside the triangle, seen from above.  `t`
// and `centre` are in a frame with the z axis up.  R converts vectors from the base frame B, the
// frame of `hull`, to this frame.  REQUIRES: seen from above, `centre` is inside `t`.
void SinkToSupport(const Hull& hull, const Matrix3d& R, const Vector3d& centre, Triangle* t) {
  // Limit of the number of passes, each of which replaces one corner of the triangle by a lower
  // point of the hull.  The hulls of our robot models need far fewer passes.
  constexpr int kSwapsMax = 64;
  for (int swaps = 0; swaps < kSwapsMax; ++swaps) {
    const Plane plane = Through(*t);
    const Vector3d n_B = R.transpose() * Vector3d(-plane.a, -plane.b, 1);
    const Vector3d p = R * hull.LowestAlong(n_B, R.row(2));
    if (p.z() > plane.a * p.x() + plane.b * p.y() + plane.c - 1e-9) return;
    Triangle next = *t;
    for (int k = 0; k < 3; ++k) {  // index of the corner that the lower point p replaces
      next = *t;
      next[k] = p;
      if (IsInsideFromAbove(next, centre)) break;
    }
    // Ends the search if `next` has no area when it is seen from above: the new corner p is then in
    // line with the two other corners.
    if (Cross2(next[0], next[1], next[2]) < 1e-12) return;
    *t = next;
  }
}

}  // namespace

StiffRobot::StiffRobot(const RobotModel& model)
    : StiffRobot(model, std::vector<double>(model.joints.size(), 0.0)) {}

StiffRobot::StiffRobot(const RobotModel& model, const std::vector<double>& angles_rad)
    : model_(model),
      angles_rad_(angles_rad),
      // Starts with infinite angles.  No angle of a joint equals such an angle, so the first Move()
      // places all parts.
      placed_rad_(model.joints.size(), std::numeric_limits<double>::infinity()),
      X_BL_(model.bodies.size(), Isometry3d::Identity()),
      moments_(model.bodies.size(), Vector3d::Zero()),
      has_moved_(model.bodies.size(), false),
      hull_(model) {
  ASSERT(angles_rad.size() == model.joints.size(), "{} angles for {} joints", angles_rad.size(),
         model.joints.size());
  for (const BodyPart& part : model.bodies) mass_kg_ += part.mass_kg;
  PlacePart(0);
  Move();
}

void StiffRobot::Move() {
  // Goes through the parts in the order of the model, which lists a parent before its children.  So
  // the pose of the parent is known when a part is reached.
  for (size_t i = 1; i < X_BL_.size(); ++i) {
    const auto j = static_cast<size_t>(model_.bodies[i].joint);
    const JointModel& joint = model_.joints[j];
    const auto parent = static_cast<size_t>(joint.parent);
    has_moved_[i] = has_moved_[parent] || angles_rad_[j] != placed_rad_[j];
    if (!has_moved_[i]) continue;
    placed_rad_[j] = angles_rad_[j];
    const Matrix3d R = AxisRotation(joint.axis, angles_rad_[j]);
    const Isometry3d& X_BP = X_BL_[parent];
    X_BL_[i].linear() = X_BP.linear() * R;
    X_BL_[i].translation() = Moved(X_BP, joint.anchor_m - R * joint.anchor_m);
    PlacePart(i);
  }
}

// Computes two results from the pose of part `i`: the moment of the part (its mass times its centre
// of mass), and the places of its box and its paws in hull_.
void StiffRobot::PlacePart(size_t i) {
  moments_[i] = model_.bodies[i].mass_kg * Moved(X_BL_[i], model_.bodies[i].centre_m);
  hull_.Move(static_cast<int>(i), X_BL_[i]);
}

Vector3d StiffRobot::CentreOfMass() const {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& moment : moments_) sum += moment;
  return sum / mass_kg_;
}

// Returns the point below which PlaceOnFloor() looks for the support, the triangle of points on
// which the robot rests.  This is the centre of mass, because a robot tips over if its centre of
// mass is not above its support.  For a model without boxes or without masses, the centre of mass
// is not known.  Then returns the middle of the paws, because a robot stands on its paws.
Vector3d StiffRobot::SupportedPoint() const {
  if (model_.bodies[0].has_box && mass_kg_ > 0) return CentreOfMass();
  Vector3d sum = Vector3d::Zero();
  for (size_t paw = 0; paw < model_.paws.size(); ++paw) sum += hull_.PawCentre(paw);
  return sum / static_cast<double>(model_.paws.size());
}

void StiffRobot::PlaceOnFloor(RestingPose* pose) const {
  const Vector3d centre_B = SupportedPoint();
  Matrix3d R = Matrix3d::Identity();
  Triangle support = HugeTriangleOver(centre_B);
  double height_m = 0;
  // Each pass turns the robot so that the support found last (the triangle on which the robot
  // rests) is level.  The next pass searches along the new vertical.  The search ends when the
  // support is level already.
  for (int turn = 0; turn < 8; ++turn) {
    SinkToSupport(hull_, R, R * centre_B, &support);
    const Plane plane = Through(support);
    height_m = -plane.c;
    if (std::fabs(plane.a) < 1e-9 && std::fabs(plane.b) < 1e-9) break;
    const Matrix3d levelled =
        LevelRotation(R.transpose() * Vector3d(-plane.a, -plane.b, 1).normalized());
    for (Vector3d& corner : support) corner = levelled * (R.transpose() * corner);
    R = levelled;
    if (!IsInsideFromAbove(support, R * centre_B)) support = HugeTriangleOver(R * centre_B);
  }
  pose->X_WB = Isometry3d::Identity();
  pose->X_WB.linear() = R;
  pose->X_WB.translation() = Vector3d(0, 0, height_m);
  // All paws are tested, not only those that carry the robot: a paw that is less than kTouch_m
  // above the ground counts as touching too.
  pose->paws.resize(model_.paws.size());
  for (size_t i = 0; i < model_.paws.size(); ++i) {
    const Vector3d p_W = Moved(pose->X_WB, hull_.PawCentre(i));
    pose->paws[i] = p_W.z() - model_.paws[i].radius_m < kTouch_m;
  }
}

double StiffRobot::LowestPoint(const Isometry3d& X_WB) const {
  const Vector3d up_B = X_WB.linear().row(2);
  return Moved(X_WB, hull_.LowestAlong(up_B, up_B)).z();
}

}  // namespace openr_host
