// Finds the points at which the robots and the movable things of a world touch the floor, fixed
// things and one another.
//
// Our own code finds the points at which shapes touch the floor, spheres, cylinders and
// heightfields.  Other pairs of shapes are left to ODE's colliders for boxes and spheres.  The
// parts of one robot are not tested against each other (docs/body.md says why), so ODE's collision
// spaces are not needed.
#pragma once

#include <ode/ode.h>

#include <Eigen/Core>
#include <vector>

#include "virtualrobot/body/body.h"
#include "virtualrobot/dynamics/touch.h"

namespace openr_host {

// Names what lies on one of the two sides of a contact: a part of a robot, a thing or the floor.
struct ContactSide {
  int tree = -1;  // number of the JointTree of this side of a contact; -1: floor or fixed thing
  int part = 0;   // index of the part in the tree
};

struct ContactPoint {
  ContactSide side;   // the side that can move
  ContactSide other;  // the side that `side` touches
  int paw = -1;       // index of the touching paw in RobotModel::paws; -1: no paw touches
  Eigen::Vector3d p_W{0, 0, 0};
  Eigen::Vector3d normal_W{0, 0, 1};  // unit vector that points out of `other`
  double depth_m = 0;                 // penetration depth, >= 0
};

class ContactFinder {
 public:
  // `things` are the things of the world in their present places.  `bodies` has for each thing the
  // ODE body that moves it, or null for a fixed thing.  The JointTrees of the movable things have
  // the numbers 0, 1 and so on, in the order of the things.  `things` and `bodies` must outlive the
  // finder.
  ContactFinder(const std::vector<WorldThing>& things, const std::vector<dBodyID>& bodies);
  ~ContactFinder();
  ContactFinder(const ContactFinder&) = delete;
  ContactFinder& operator=(const ContactFinder&) = delete;

  // Adds a robot that JointTree number `tree` moves, and whose parts are the ODE bodies `bodies`,
  // in the order of `model`.  `model` and `bodies` must outlive the finder.
  void AddRobot(int tree, const RobotModel& model, const std::vector<dBodyID>& bodies);

  // Returns all points at which something touches something else now: first the points of the
  // movable things, then the points of each robot, in the order of its model.  The result is valid
  // until the next call.
  const std::vector<ContactPoint>& Find();

 private:
  // A box along the axes of W that encloses a shape or a robot: its least and greatest x, then y,
  // then z, in ODE's order.
  struct Room {
    dReal edges[6];
    bool IsSeparateFrom(const Room& other) const;
  };

  // A shape that can touch others: a box or a ball of a robot, or a thing.
  struct Shape {
    ThingShape shape = ThingShape::kBox;
    Eigen::Vector3d size_m{0, 0, 0};  // size of the shape, with the meaning of WorldThing::size_m
    ContactSide side;
    int paw = -1;
    dGeomID geom = nullptr;
    dBodyID body = nullptr;             // null: the shape is fixed
    Eigen::Vector3d offset_m{0, 0, 0};  // shape's centre minus body's centre of mass, in body axes
    const WorldThing* thing = nullptr;  // null: the shape is a part of a robot
    Room room = {};

    Eigen::Vector3d CentreW() const;
    Eigen::Matrix3d R_W() const;
  };

  struct Robot {
    std::vector<Shape> boxes, balls;
    Room room = {};
  };

  void FindOfThing(size_t thing);
  void FindOfRobot(size_t robot);
  void FindRoom(Robot* robot);
  void FindOnOthers(const Shape& shape, size_t robot);

  // The next functions add the points at which a shape touches the floor or another shape to
  // points_.
  void FindOnFloor(const Shape& shape);
  void FindBallOnFloor(const Shape& ball);
  void FindBoxOnFloor(const Shape& box);
  void FindCylinderOnFloor(const Shape& cylinder);
  void FindOn(const Shape& shape, const Shape& other);
  void FindByOde(const Shape& shape, const Shape& other);
  void FindOnHeights(const Shape& shape, const Shape& other);
  void FindOnRound(const Shape& shape, const Shape& other, bool swapped);
  void AddTouches(const Shape& shape, const Shape& other, bool swapped);

  std::vector<Shape> things_;  // shapes of the solid things
  std::vector<Robot> robots_;
  std::vector<const Shape*> near_;  // things near the robot that FindOfRobot() looks at
  std::vector<ContactPoint> points_;
  std::vector<TouchPoint> touches_;
};

}  // namespace openr_host
