#include "virtualrobot/ode/contact_finder.h"

#include <algorithm>
#include <cmath>

#include "virtualrobot/ode/ode_bodies.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

// Maximum number of contacts of one box with the floor.  A box that lies flat touches with four
// corners.  More corners are below the floor only when the box is deep in it, and then four
// contacts are enough to push it out.
constexpr int kCornersMax = 4;

// Number of contacts that ODE's box collider is asked for.  The collider finds at most eight.  When
// asked for fewer, it chooses points by their angle with atan2 of libm, whose bits differ between
// processors.
constexpr int kPointsMax = 8;

// Makes a geometry of the size of `thing`.
dGeomID GeomOf(const WorldThing& thing) {
  const Vector3d& size = thing.size_m;
  if (thing.shape == ThingShape::kSphere) return dCreateSphere(nullptr, size.x() / 2);
  if (thing.shape == ThingShape::kCylinder) return dCreateCylinder(nullptr, size.x() / 2, size.z());
  return dCreateBox(nullptr, size.x(), size.y(), size.z());
}

}  // namespace

ContactFinder::ContactFinder(const RobotModel& model, const World& world,
                             const std::vector<dBodyID>& bodies)
    : model_(model), bodies_(bodies), things_(world.things) {
  // Because the floor is tested without ODE, parts need an ODE geometry only in a world with
  // things.
  if (things_.empty()) return;
  for (const WorldThing& thing : things_) {
    const dGeomID geom = GeomOf(thing);
    const Eigen::Matrix3d& m = thing.R_WT;
    const dMatrix3 R = {m(0, 0), m(0, 1), m(0, 2), 0,       m(1, 0), m(1, 1),
                        m(1, 2), 0,       m(2, 0), m(2, 1), m(2, 2), 0};
    dGeomSetPosition(geom, thing.centre_m.x(), thing.centre_m.y(), thing.centre_m.z());
    dGeomSetRotation(geom, R);
    thing_geoms_.push_back(geom);
  }
  for (size_t i = 0; i < bodies.size(); ++i) {
    const Vector3d& size = model.bodies[i].size_m;
    part_boxes_.push_back(dCreateBox(nullptr, size.x(), size.y(), size.z()));
    dGeomSetBody(part_boxes_.back(), bodies[i]);
  }
  for (const Paw& paw : model.paws) {
    const Vector3d offset = paw.centre_m - model.bodies[paw.body].centre_m;
    paw_balls_.push_back(dCreateSphere(nullptr, paw.radius_m));
    dGeomSetBody(paw_balls_.back(), bodies[paw.body]);
    dGeomSetOffsetPosition(paw_balls_.back(), offset.x(), offset.y(), offset.z());
  }
}

ContactFinder::~ContactFinder() {
  for (const dGeomID geom : paw_balls_) dGeomDestroy(geom);
  for (const dGeomID geom : part_boxes_) dGeomDestroy(geom);
  for (const dGeomID geom : thing_geoms_) dGeomDestroy(geom);
}

const std::vector<ContactPoint>& ContactFinder::Find() {
  points_.clear();
  for (size_t i = 0; i < bodies_.size(); ++i) {
    FindBoxOnFloor(static_cast<int>(i));
    if (!things_.empty()) FindOnThings(static_cast<int>(i), -1);
  }
  for (size_t k = 0; k < model_.paws.size(); ++k) {
    FindPawOnFloor(static_cast<int>(k));
    if (!things_.empty()) FindOnThings(model_.paws[k].body, static_cast<int>(k));
  }
  KeepDeepest();
  return points_;
}

// Leaves out all but the deepest points, because the work of the solver grows with their third
// power.  Equal points keep their order.
void ContactFinder::KeepDeepest() {
  if (points_.size() <= kContactsMax) return;
  std::stable_sort(
      points_.begin(), points_.end(),
      [](const ContactPoint& a, const ContactPoint& b) { return a.depth_m > b.depth_m; });
  points_.resize(kContactsMax);
}

void ContactFinder::FindPawOnFloor(int paw) {
  const Paw& model_paw = model_.paws[paw];
  const dReal* p = dBodyGetPosition(bodies_[model_paw.body]);
  const dReal* R = dBodyGetRotation(bodies_[model_paw.body]);
  const Vector3d l = model_paw.centre_m - model_.bodies[model_paw.body].centre_m;
  const double z = p[2] + R[8] * l.x() + R[9] * l.y() + R[10] * l.z();
  const double depth_m = model_paw.radius_m - z;
  if (depth_m <= 0) return;
  ContactPoint point;
  point.body = model_paw.body;
  point.paw = paw;
  point.p_W = Vector3d(p[0] + R[0] * l.x() + R[1] * l.y() + R[2] * l.z(),
                       p[1] + R[4] * l.x() + R[5] * l.y() + R[6] * l.z(), -depth_m);
  point.depth_m = depth_m;
  points_.push_back(point);
}

void ContactFinder::FindBoxOnFloor(int body) {
  const Vector3d half = model_.bodies[body].size_m / 2;
  const dReal* p = dBodyGetPosition(bodies_[body]);
  const dReal* R = dBodyGetRotation(bodies_[body]);
  const double zx = R[8] * half.x(), zy = R[9] * half.y(), zz = R[10] * half.z();
  if (p[2] >= std::fabs(zx) + std::fabs(zy) + std::fabs(zz)) return;
  // From here on the lowest corner is below the floor, so the loop finds at least one corner.
  int found = 0;
  for (int corner = 0; corner < 8 && found < kCornersMax; ++corner) {
    const double sx = corner & 1 ? 1 : -1, sy = corner & 2 ? 1 : -1, sz = corner & 4 ? 1 : -1;
    const double z = p[2] + sx * zx + sy * zy + sz * zz;
    if (z >= 0) continue;
    found += 1;
    const double x = sx * half.x(), y = sy * half.y(), w = sz * half.z();
    ContactPoint point;
    point.body = body;
    point.p_W =
        Vector3d(p[0] + R[0] * x + R[1] * y + R[2] * w, p[1] + R[4] * x + R[5] * y + R[6] * w, z);
    point.depth_m = -z;
    points_.push_back(point);
  }
}

void ContactFinder::FindOnThings(int body, int paw) {
  const dGeomID part = paw >= 0 ? paw_balls_[paw] : part_boxes_[body];
  // Bounding boxes are compared first, because this is cheap and most parts are far from most
  // things.
  dReal reach[6];
  dGeomGetAABB(part, reach);
  for (size_t t = 0; t < things_.size(); ++t) {
    dReal room[6];
    dGeomGetAABB(thing_geoms_[t], room);
    bool apart = false;
    for (int i = 0; i < 6; i += 2)
      apart = apart || reach[i] > room[i + 1] || reach[i + 1] < room[i];
    if (apart) continue;
    if (things_[t].shape == ThingShape::kBox) {
      FindOnBox(part, thing_geoms_[t], body, paw);
    } else {
      FindOnRoundThing(things_[t], body, paw);
    }
  }
}

void ContactFinder::FindOnBox(dGeomID part, dGeomID box, int body, int paw) {
  dContactGeom found[kPointsMax];
  const int count = dCollide(part, box, kPointsMax, found, sizeof(dContactGeom));
  for (int i = 0; i < count; ++i) {
    ContactPoint point;
    point.body = body;
    point.paw = paw;
    point.p_W = Vector3d(found[i].pos[0], found[i].pos[1], found[i].pos[2]);
    point.normal_W = Vector3d(found[i].normal[0], found[i].normal[1], found[i].normal[2]);
    point.depth_m = found[i].depth;
    points_.push_back(point);
  }
}

void ContactFinder::FindOnRoundThing(const WorldThing& thing, int body, int paw) {
  const Vector3d centre_W = ToEigen(dBodyGetPosition(bodies_[body]));
  const Eigen::Matrix3d R_WL = RotationOf(bodies_[body]);
  touches_.clear();
  if (paw >= 0) {
    const Paw& ball = model_.paws[paw];
    const Vector3d offset = ball.centre_m - model_.bodies[body].centre_m;
    TouchBall(centre_W + R_WL * offset, ball.radius_m, thing, &touches_);
  } else {
    TouchBox(centre_W, R_WL, model_.bodies[body].size_m, thing, &touches_);
  }
  for (const TouchPoint& touch : touches_) {
    ContactPoint point;
    point.body = body;
    point.paw = paw;
    point.p_W = touch.p_W;
    point.normal_W = touch.normal_W;
    point.depth_m = touch.depth_m;
    points_.push_back(point);
  }
}

}  // namespace openr_host
