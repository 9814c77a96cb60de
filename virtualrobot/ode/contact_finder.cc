#include "virtualrobot/ode/contact_finder.h"

#include <algorithm>
#include <cmath>

#include "virtualrobot/dynamics/height_field.h"
#include "virtualrobot/ode/ode_bodies.h"

namespace openr_host {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Maximum number of contacts of one box with the floor.  A box that lies flat touches with four
// corners.  More than four corners are below the floor only when the box is deep in the floor.
// Four contacts are then enough to push the box out.
constexpr int kCornersMax = 4;

// Number of contacts that ODE's box collider is asked for.  The collider finds at most eight, so we
// ask for all.  When asked for fewer, it would choose points by their angle with atan2 of libm,
// whose bits differ between processors.
constexpr int kPointsMax = 8;

// Makes an ODE geometry with the shape and the size of `thing`.
dGeomID GeomOf(const WorldThing& thing) {
  const Vector3d& size = thing.size_m;
  if (thing.shape == ThingShape::kSphere) return dCreateSphere(nullptr, size.x() / 2);
  if (thing.shape == ThingShape::kCylinder) return dCreateCylinder(nullptr, size.x() / 2, size.z());
  return dCreateBox(nullptr, size.x(), size.y(), size.z());
}

void PlaceGeom(dGeomID geom, const WorldThing& thing) {
  const Matrix3d& m = thing.R_WT;
  const dMatrix3 R = {m(0, 0), m(0, 1), m(0, 2), 0,       m(1, 0), m(1, 1),
                      m(1, 2), 0,       m(2, 0), m(2, 1), m(2, 2), 0};
  dGeomSetPosition(geom, thing.centre_m.x(), thing.centre_m.y(), thing.centre_m.z());
  dGeomSetRotation(geom, R);
}

}  // namespace

bool ContactFinder::Room::IsSeparateFrom(const Room& other) const {
  bool apart = false;
  for (int i = 0; i < 6; i += 2)
    apart = apart || edges[i] > other.edges[i + 1] || edges[i + 1] < other.edges[i];
  return apart;
}

Vector3d ContactFinder::Shape::CentreW() const {
  if (body == nullptr) return thing->centre_m;
  const dReal* const p = dBodyGetPosition(body);
  const dReal* const R = dBodyGetRotation(body);
  const Vector3d& l = offset_m;
  return {p[0] + R[0] * l.x() + R[1] * l.y() + R[2] * l.z(),
          p[1] + R[4] * l.x() + R[5] * l.y() + R[6] * l.z(),
          p[2] + R[8] * l.x() + R[9] * l.y() + R[10] * l.z()};
}

Matrix3d ContactFinder::Shape::R_W() const {
  return body == nullptr ? thing->R_WT : RotationOf(body);
}

ContactFinder::ContactFinder(const std::vector<WorldThing>& things,
                             const std::vector<dBodyID>& bodies) {
  int trees = 0;
  for (size_t i = 0; i < things.size(); ++i) {
    Shape shape;
    shape.side.tree = bodies[i] == nullptr ? -1 : trees++;
    if (!things[i].is_solid) continue;
    shape.shape = things[i].shape;
    shape.size_m = things[i].size_m;
    shape.thing = &things[i];
    shape.geom = GeomOf(things[i]);
    shape.body = bodies[i];
    if (shape.body == nullptr) {
      PlaceGeom(shape.geom, things[i]);
      dGeomGetAABB(shape.geom, shape.room.edges);
    } else {
      dGeomSetBody(shape.geom, shape.body);
    }
    things_.push_back(shape);
  }
}

ContactFinder::~ContactFinder() {
  for (const Robot& robot : robots_) {
    for (const Shape& ball : robot.balls) dGeomDestroy(ball.geom);
    for (const Shape& box : robot.boxes) dGeomDestroy(box.geom);
  }
  for (const Shape& thing : things_) dGeomDestroy(thing.geom);
}

void ContactFinder::AddRobot(int tree, const RobotModel& model,
                             const std::vector<dBodyID>& bodies) {
  Robot robot;
  for (size_t i = 0; i < bodies.size(); ++i) {
    Shape box;
    box.size_m = model.bodies[i].size_m;
    box.side = {tree, static_cast<int>(i)};
    box.body = bodies[i];
    box.geom = dCreateBox(nullptr, box.size_m.x(), box.size_m.y(), box.size_m.z());
    dGeomSetBody(box.geom, box.body);
    robot.boxes.push_back(box);
  }
  for (size_t k = 0; k < model.paws.size(); ++k) {
    const Paw& paw = model.paws[k];
    Shape ball;
    ball.shape = ThingShape::kSphere;
    ball.size_m.setConstant(2 * paw.radius_m);
    ball.side = {tree, paw.body};
    ball.paw = static_cast<int>(k);
    ball.body = bodies[static_cast<size_t>(paw.body)];
    ball.offset_m = paw.centre_m - model.bodies[static_cast<size_t>(paw.body)].centre_m;
    ball.geom = dCreateSphere(nullptr, paw.radius_m);
    dGeomSetBody(ball.geom, ball.body);
    dGeomSetOffsetPosition(ball.geom, ball.offset_m.x(), ball.offset_m.y(), ball.offset_m.z());
    robot.balls.push_back(ball);
  }
  robots_.push_back(std::move(robot));
}

const std::vector<ContactPoint>& ContactFinder::Find() {
  points_.clear();
  for (Shape& thing : things_) {
    if (thing.body != nullptr) dGeomGetAABB(thing.geom, thing.room.edges);
  }
  // Finds the rooms (enclosing boxes) of robots only if there is anything to touch besides the
  // floor. The tests with the floor need no rooms.
  if (!things_.empty() || robots_.size() > 1) {
    for (Robot& robot : robots_) FindRoom(&robot);
  }
  for (size_t t = 0; t < things_.size(); ++t) {
    if (things_[t].body != nullptr) FindOfThing(t);
  }
  for (size_t r = 0; r < robots_.size(); ++r) FindOfRobot(r);
  return points_;
}

// Finds the room (enclosing box) of each shape of the robot, and the room that encloses all shapes.
void ContactFinder::FindRoom(Robot* robot) {
  Room& all = robot->room;
  for (int i = 0; i < 6; ++i) all.edges[i] = i % 2 == 0 ? dInfinity : -dInfinity;
  for (std::vector<Shape>* const shapes : {&robot->boxes, &robot->balls}) {
    for (Shape& shape : *shapes) {
      dGeomGetAABB(shape.geom, shape.room.edges);
      for (int i = 0; i < 6; i += 2) {
        all.edges[i] = std::min(all.edges[i], shape.room.edges[i]);
        all.edges[i + 1] = std::max(all.edges[i + 1], shape.room.edges[i + 1]);
      }
    }
  }
}

// Finds the contacts of a movable thing with the floor, with fixed things, and with movable things
// that come after it in things_, so that each pair is tested only once.
void ContactFinder::FindOfThing(size_t thing) {
  FindOnFloor(things_[thing]);
  for (size_t other = 0; other < things_.size(); ++other) {
    const bool is_earlier = other <= thing && things_[other].body != nullptr;
    if (!is_earlier && !things_[thing].room.IsSeparateFrom(things_[other].room))
      FindOn(things_[thing], things_[other]);
  }
}

void ContactFinder::FindOfRobot(size_t robot) {
  near_.clear();
  for (const Shape& thing : things_) {
    if (!robots_[robot].room.IsSeparateFrom(thing.room)) near_.push_back(&thing);
  }
  for (const std::vector<Shape>* const shapes : {&robots_[robot].boxes, &robots_[robot].balls}) {
    for (const Shape& shape : *shapes) {
      FindOnFloor(shape);
      FindOnOthers(shape, robot);
    }
  }
}

// Adds the points at which `shape`, which belongs to robot `robot`, touches things and other
// robots.  A pair of boxes of two robots is tested only once, for the robot with the lower number.
void ContactFinder::FindOnOthers(const Shape& shape, size_t robot) {
  for (const Shape* const thing : near_) {
    if (!shape.room.IsSeparateFrom(thing->room)) FindOn(shape, *thing);
  }
  for (size_t other = 0; other < robots_.size(); ++other) {
    if (other == robot || (shape.paw < 0 && other < robot)) continue;
    if (robots_[robot].room.IsSeparateFrom(robots_[other].room)) continue;
    for (const Shape& box : robots_[other].boxes) {
      if (!shape.room.IsSeparateFrom(box.room)) FindOn(shape, box);
    }
  }
}

void ContactFinder::FindOnFloor(const Shape& shape) {
  if (shape.shape == ThingShape::kBox) return FindBoxOnFloor(shape);
  if (shape.shape == ThingShape::kSphere) return FindBallOnFloor(shape);
  FindCylinderOnFloor(shape);
}

void ContactFinder::FindBallOnFloor(const Shape& ball) {
  const Vector3d centre_W = ball.CentreW();
  const double depth_m = ball.size_m.x() / 2 - centre_W.z();
  if (depth_m <= 0) return;
  ContactPoint point;
  point.side = ball.side;
  point.paw = ball.paw;
  point.p_W = Vector3d(centre_W.x(), centre_W.y(), -depth_m);
  point.depth_m = depth_m;
  points_.push_back(point);
}

void ContactFinder::FindBoxOnFloor(const Shape& box) {
  const Vector3d half = box.size_m / 2;
  const dReal* p = dBodyGetPosition(box.body);
  const dReal* R = dBodyGetRotation(box.body);
  const double zx = R[8] * half.x(), zy = R[9] * half.y(), zz = R[10] * half.z();
  // The sum is the height of the box's centre above its lowest corner.  If the centre is at least
  // this high, no corner is below the floor.
  if (p[2] >= std::fabs(zx) + std::fabs(zy) + std::fabs(zz)) return;
  int found = 0;
  for (int corner = 0; corner < 8 && found < kCornersMax; ++corner) {
    const double sx = corner & 1 ? 1 : -1, sy = corner & 2 ? 1 : -1, sz = corner & 4 ? 1 : -1;
    const double z = p[2] + sx * zx + sy * zy + sz * zz;
    if (z >= 0) continue;
    found += 1;
    const double x = sx * half.x(), y = sy * half.y(), w = sz * half.z();
    ContactPoint point;
    point.side = box.side;
    point.p_W =
        Vector3d(p[0] + R[0] * x + R[1] * y + R[2] * w, p[1] + R[4] * x + R[5] * y + R[6] * w, z);
    point.depth_m = -z;
    points_.push_back(point);
  }
}

// Adds the points at which a cylinder touches the floor.  Tests four points on the rim of each end:
// the lowest point, and the points a quarter, a half and three quarters of the rim further.
void ContactFinder::FindCylinderOnFloor(const Shape& cylinder) {
  const Vector3d centre_W = cylinder.CentreW();
  const Matrix3d R = cylinder.R_W();
  const double radius_m = cylinder.size_m.x() / 2;
  // Finds the direction from the centre of an end to the lowest point of its rim, in the axes of
  // the cylinder.  The z coordinates, in W, of the cylinder's x axis and y axis give this
  // direction.
  Vector3d down(-R(2, 0), -R(2, 1), 0);
  const double length = std::sqrt(down.x() * down.x() + down.y() * down.y());
  if (length > 0) {
    down /= length;
  } else {
    down = Vector3d::UnitX();
  }
  for (const double end : {-0.5, 0.5}) {
    Vector3d way = down;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Vector3d p_W =
          centre_W + R * (radius_m * way + Vector3d(0, 0, end * cylinder.size_m.z()));
      way = Vector3d(-way.y(), way.x(), 0);
      if (p_W.z() >= 0) continue;
      ContactPoint point;
      point.side = cylinder.side;
      point.p_W = p_W;
      point.depth_m = -p_W.z();
      points_.push_back(point);
    }
  }
}

// Adds the points at which `shape` touches `other`.  FindOnHeights() finds the points if `other` is
// a heightfield; `shape` is never a heightfield, because a heightfield cannot move.  ODE finds the
// points if `other` is a box and `shape` is a box or a ball.  Every other pair has at least one
// ball or cylinder, which FindOnRound() gets as its parameter `other`.
void ContactFinder::FindOn(const Shape& shape, const Shape& other) {
  if (other.shape == ThingShape::kHeightField) return FindOnHeights(shape, other);
  const bool shape_is_cylinder = shape.shape == ThingShape::kCylinder;
  if (other.shape == ThingShape::kBox && !shape_is_cylinder) return FindByOde(shape, other);
  const bool swapped = shape_is_cylinder && other.shape != ThingShape::kCylinder;
  FindOnRound(swapped ? other : shape, swapped ? shape : other, swapped);
}

void ContactFinder::FindByOde(const Shape& shape, const Shape& other) {
  dContactGeom found[kPointsMax];
  const int count = dCollide(shape.geom, other.geom, kPointsMax, found, sizeof(dContactGeom));
  for (int i = 0; i < count; ++i) {
    ContactPoint point;
    point.side = shape.side;
    point.other = other.side;
    point.paw = shape.paw;
    point.p_W = Vector3d(found[i].pos[0], found[i].pos[1], found[i].pos[2]);
    point.normal_W = Vector3d(found[i].normal[0], found[i].normal[1], found[i].normal[2]);
    point.depth_m = found[i].depth;
    points_.push_back(point);
  }
}

// Adds the points at which `shape` touches the heightfield `other`.  A cylinder is treated as the
// largest box that fits into it.
void ContactFinder::FindOnHeights(const Shape& shape, const Shape& other) {
  constexpr double kEdgeOfSquareInCircle = 0.70710678118654752440;
  touches_.clear();
  if (shape.shape == ThingShape::kSphere) {
    TouchBallOnHeights(shape.CentreW(), shape.size_m.x() / 2, *other.thing, &touches_);
  } else {
    Vector3d size_m = shape.size_m;
    if (shape.shape == ThingShape::kCylinder) size_m.head<2>() *= kEdgeOfSquareInCircle;
    TouchBoxOnHeights(shape.CentreW(), shape.R_W(), size_m, *other.thing, &touches_);
  }
  AddTouches(shape, other, false);
}

// Adds the points at which `shape` touches the ball or cylinder `other`.  `swapped` is true if
// FindOn() has exchanged its two shapes; `other` is then the shape that can move, and `shape` may
// be fixed.
void ContactFinder::FindOnRound(const Shape& shape, const Shape& other, bool swapped) {
  touches_.clear();
  if (shape.shape == ThingShape::kBox) {
    TouchBox(shape.CentreW(), shape.R_W(), shape.size_m, *other.thing, &touches_);
  } else if (shape.shape == ThingShape::kSphere) {
    TouchBall(shape.CentreW(), shape.size_m.x() / 2, *other.thing, &touches_);
  } else {
    TouchCylinders(*shape.thing, *other.thing, &touches_);
  }
  AddTouches(shape, other, swapped);
}

// Adds a ContactPoint to points_, the result of Find(), for each point in touches_, at which
// `shape` touches `other`.  The normals in touches_ point out of `other`.  A ContactPoint needs a
// normal that points towards the shape that can move.  If `swapped` is true, this shape is `other`,
// so the function exchanges the two shapes and turns the normals round.
void ContactFinder::AddTouches(const Shape& shape, const Shape& other, bool swapped) {
  for (const TouchPoint& touch : touches_) {
    ContactPoint point;
    point.side = swapped ? other.side : shape.side;
    point.other = swapped ? shape.side : other.side;
    point.paw = shape.paw;
    point.p_W = touch.p_W;
    point.normal_W = swapped ? Vector3d(-touch.normal_W) : touch.normal_W;
    point.depth_m = touch.depth_m;
    points_.push_back(point);
  }
}

}  // namespace openr_host
