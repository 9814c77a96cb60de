#include "virtualrobot/kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "runtime/base/assert.h"
#include "virtualrobot/det_math.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Distance below which a paw counts as touching the floor.  In all standing postures of the
// ERS-210, the four paws (balls in the model) end in one plane within 0.1 mm, so all of them touch
// the floor.
constexpr double kTouch_m = 0.0005;

// Returns X * p.  Leaves out the fourth row of X, because it is always 0, 0, 0, 1.
Vector3d Moved(const Isometry3d& X, const Vector3d& p) { return X.linear() * p + X.translation(); }

// Returns the rotation R_WB with yaw 0 whose third row is `up_B`, the direction up of the world,
// seen from B.
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

// All balls and boxes of a robot that can touch the floor, in B.
class Hull {
 public:
  Hull(const RobotModel& model, const std::vector<Isometry3d>& X_BL) {
    balls_.reserve(model.paws.size());
    for (const Paw& paw : model.paws) {
      balls_.push_back({Moved(X_BL[paw.body], paw.centre_m), paw.radius_m});
    }
    boxes_.reserve(model.bodies.size());
    for (size_t i = 0; i < model.bodies.size(); ++i) {
      const BodyPart& body = model.bodies[i];
      if (!body.has_box) continue;
      const Matrix3d half_edges = X_BL[i].linear() * (body.size_m / 2).asDiagonal();
      boxes_.push_back({Moved(X_BL[i], body.centre_m), half_edges});
    }
  }

  // Returns the point that lies furthest against the direction `n_B`.  A ball is taken as one
  // point: the lowest point for the direction `up_B`, which is a unit vector near n_B.
  Vector3d LowestAlong(const Vector3d& n_B, const Vector3d& up_B) const {
    double best = std::numeric_limits<double>::infinity();
    Vector3d lowest = Vector3d::Zero();
    for (const Ball& ball : balls_) {
      const Vector3d p = ball.centre - ball.radius * up_B;
      const double height = n_B.dot(p);
      if (height < best) best = height, lowest = p;
    }
    for (const Box& box : boxes_) {
      const Vector3d reach = box.half_edges.transpose() * n_B;
      const double height = n_B.dot(box.centre) -
                            (std::fabs(reach.x()) + std::fabs(reach.y()) + std::fabs(reach.z()));
      if (height >= best) continue;
      best = height;
      const Vector3d side(reach.x() > 0 ? -1 : 1, reach.y() > 0 ? -1 : 1, reach.z() > 0 ? -1 : 1);
      lowest = box.centre + box.half_edges * side;
    }
    return lowest;
  }

 private:
  struct Ball {
    Vector3d centre;
    double radius;
  };
  struct Box {
    Vector3d centre;
    Matrix3d half_edges;  // its columns are half the edges of the box
  };
  std::vector<Ball> balls_;
  std::vector<Box> boxes_;
};

using Triangle = std::array<Vector3d, 3>;  // corners counterclockwise, seen from above

double Cross2(const Vector3d& o, const Vector3d& p, const Vector3d& q) {
  return (p.x() - o.x()) * (q.y() - o.y()) - (p.y() - o.y()) * (q.x() - o.x());
}

// Returns whether p is inside the triangle `t`, seen from above.
bool Under(const Triangle& t, const Vector3d& p) {
  return Cross2(t[0], t[1], p) >= 0 && Cross2(t[1], t[2], p) >= 0 && Cross2(t[2], t[0], p) >= 0;
}

struct Plane {  // z = a x + b y + c
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

// Moves the triangle `t` down until it is the face of the lower hull under `centre`.  In each pass,
// the hull's point that is furthest below the plane of the triangle replaces one corner.  The
// corner is chosen so that `centre` still lies over the triangle.  `t` and `centre` are in a frame
// that is turned by R from B.  REQUIRES: `centre` lies over `t`.
void SinkToSupport(const Hull& hull, const Matrix3d& R, const Vector3d& centre, Triangle* t) {
  constexpr int kSwapsMax = 64;  // far more than the hulls of these robots need
  for (int swaps = 0; swaps < kSwapsMax; ++swaps) {
    const Plane plane = Through(*t);
    const Vector3d n_B = R.transpose() * Vector3d(-plane.a, -plane.b, 1);
    const Vector3d p = R * hull.LowestAlong(n_B, R.row(2));
    if (p.z() > plane.a * p.x() + plane.b * p.y() + plane.c - 1e-9) return;
    Triangle next = *t;
    for (int k = 0; k < 3; ++k) {  // index of the corner that p replaces
      next = *t;
      next[k] = p;
      if (Under(next, centre)) break;
    }
    if (Cross2(next[0], next[1], next[2]) < 1e-12) return;  // p lies in line with an edge
    *t = next;
  }
}

// Returns the point that must lie above the support, the triangle of points on which the robot
// rests, because otherwise it tips over.  This is the centre of mass.  For a model without boxes it
// is the middle of the paws, because such a robot can rest only on its paws.
Vector3d SupportedPoint(const RobotModel& model, const std::vector<Isometry3d>& X_BL) {
  if (model.bodies[0].has_box) return CentreOfMass(model, X_BL);
  Vector3d sum = Vector3d::Zero();
  for (const Paw& paw : model.paws) sum += Moved(X_BL[paw.body], paw.centre_m);
  return sum / static_cast<double>(model.paws.size());
}

}  // namespace

Matrix3d AxisRotation(const Vector3d& axis, double angle_rad) {
  const double s = DetSin(angle_rad), c = DetCos(angle_rad);
  const double x = axis.x(), y = axis.y(), z = axis.z(), v = 1 - c;
  Matrix3d R;
  R << x * x * v + c, x * y * v - z * s, x * z * v + y * s,  //
      x * y * v + z * s, y * y * v + c, y * z * v - x * s,   //
      x * z * v - y * s, y * z * v + x * s, z * z * v + c;
  return R;
}

Matrix3d RotationFromRpy(const Vector3d& rpy_rad) {
  return AxisRotation(Vector3d::UnitZ(), rpy_rad.z()) *
         AxisRotation(Vector3d::UnitY(), rpy_rad.y()) *
         AxisRotation(Vector3d::UnitX(), rpy_rad.x());
}

Vector3d RpyOf(const Matrix3d& R) {
  const double cp = std::sqrt(R(0, 0) * R(0, 0) + R(1, 0) * R(1, 0));
  return {DetAtan2(R(2, 1), R(2, 2)), DetAtan2(-R(2, 0), cp), DetAtan2(R(1, 0), R(0, 0))};
}

std::vector<Isometry3d> LinkPoses(const RobotModel& model, const std::vector<double>& angles_rad) {
  ASSERT(angles_rad.size() == model.joints.size(), "{} angles for {} joints", angles_rad.size(),
         model.joints.size());
  std::vector<Isometry3d> X_BL(model.bodies.size(), Isometry3d::Identity());
  for (size_t i = 1; i < model.bodies.size();
       ++i) {  // in this order, because parents come before their children
    const int j = model.bodies[i].joint;
    const JointModel& joint = model.joints[j];
    const Matrix3d R = AxisRotation(joint.axis, angles_rad[j]);
    const Isometry3d& X_BP = X_BL[joint.parent];
    X_BL[i].linear() = X_BP.linear() * R;
    X_BL[i].translation() = Moved(X_BP, joint.anchor_m - R * joint.anchor_m);
  }
  return X_BL;
}

Vector3d CentreOfMass(const RobotModel& model, const std::vector<Isometry3d>& X_BL) {
  Vector3d sum = Vector3d::Zero();
  double mass_kg = 0;
  for (size_t i = 0; i < model.bodies.size(); ++i) {
    sum += model.bodies[i].mass_kg * Moved(X_BL[i], model.bodies[i].centre_m);
    mass_kg += model.bodies[i].mass_kg;
  }
  return sum / mass_kg;
}

RestingPose PlaceOnFloor(const RobotModel& model, const std::vector<double>& angles_rad) {
  return PlaceOnFloor(model, LinkPoses(model, angles_rad));
}

RestingPose PlaceOnFloor(const RobotModel& model, const std::vector<Isometry3d>& X_BL) {
  const Hull hull(model, X_BL);
  const Vector3d centre_B = SupportedPoint(model, X_BL);
  Matrix3d R = Matrix3d::Identity();
  Triangle support = HugeTriangleOver(centre_B);
  double height_m = 0;
  // Each pass turns the robot so that the support found last is level.  The next pass searches
  // along the new vertical.  The search ends when the support is level already.
  for (int turn = 0; turn < 8; ++turn) {
    SinkToSupport(hull, R, R * centre_B, &support);
    const Plane plane = Through(support);
    height_m = -plane.c;
    if (std::fabs(plane.a) < 1e-9 && std::fabs(plane.b) < 1e-9) break;
    const Matrix3d levelled =
        LevelRotation(R.transpose() * Vector3d(-plane.a, -plane.b, 1).normalized());
    for (Vector3d& corner : support) corner = levelled * (R.transpose() * corner);
    R = levelled;
    if (!Under(support, R * centre_B)) support = HugeTriangleOver(R * centre_B);
  }
  RestingPose pose;
  pose.X_WB.linear() = R;
  pose.X_WB.translation() = Vector3d(0, 0, height_m);
  // All paws are tested, not only those that carry the robot: a paw that is less than kTouch_m
  // above the ground counts as touching too.
  for (const Paw& paw : model.paws) {
    const Vector3d p_W = Moved(pose.X_WB, Moved(X_BL[paw.body], paw.centre_m));
    pose.paws.push_back(p_W.z() - paw.radius_m < kTouch_m);
  }
  return pose;
}

double LowestPoint(const RobotModel& model, const std::vector<double>& angles_rad,
                   const Isometry3d& X_WB) {
  const Hull hull(model, LinkPoses(model, angles_rad));
  const Vector3d up_B = X_WB.linear().row(2);
  return Moved(X_WB, hull.LowestAlong(up_B, up_B)).z();
}

}  // namespace openr_host
