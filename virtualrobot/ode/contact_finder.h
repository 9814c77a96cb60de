// Finds the points at which the paws and boxes of a robot touch the floor and the static things of
// its world.
//
// Our own code tests each part against the floor, spheres and cylinders.  Because parts are not
// tested against each other (docs/body.md says why), ODE's collision spaces are not needed.  ODE's
// colliders for boxes and spheres test the parts against static boxes.
#pragma once

#include <ode/ode.h>

#include <Eigen/Core>
#include <vector>

#include "virtualrobot/body.h"
#include "virtualrobot/dynamics/touch.h"

namespace openr_host {

struct ContactPoint {
  int body = -1;  // index of the part in RobotModel::bodies
  int paw = -1;   // index in RobotModel::paws; -1 when the part's box touches
  Eigen::Vector3d p_W{0, 0, 0};
  Eigen::Vector3d normal_W{0, 0, 1};  // unit vector out of the floor or thing
  double depth_m = 0;                 // penetration depth, >= 0
};

class ContactFinder {
 public:
  // Makes a finder for a robot whose parts are the ODE bodies `bodies`, in the order of `model`.
  // `model` and `bodies` must outlive the finder.
  ContactFinder(const RobotModel& model, const World& world, const std::vector<dBodyID>& bodies);
  ~ContactFinder();
  ContactFinder(const ContactFinder&) = delete;
  ContactFinder& operator=(const ContactFinder&) = delete;

  // Returns the points that touch now, in the order of the model; if more than kContactsMax touch,
  // the deepest ones, by depth.  The result is valid until the next call.
  static constexpr size_t kContactsMax = 64;
  const std::vector<ContactPoint>& Find();

 private:
  void KeepDeepest();
  void FindPawOnFloor(int paw);
  void FindBoxOnFloor(int body);

  // Add the points at which part `body` touches the static things.  If `paw` is not -1, they test
  // the ball of that paw instead of the part's box.
  void FindOnThings(int body, int paw);
  void FindOnBox(dGeomID part, dGeomID box, int body, int paw);
  void FindOnRoundThing(const WorldThing& thing, int body, int paw);

  const RobotModel& model_;
  const std::vector<dBodyID>& bodies_;
  std::vector<ContactPoint> points_;
  const std::vector<WorldThing> things_;
  std::vector<dGeomID> thing_geoms_;  // one for each thing; only boxes are tested with it
  std::vector<dGeomID> part_boxes_;   // one for each body; empty in a world without things
  std::vector<dGeomID> paw_balls_;    // one for each paw; empty in a world without things
  std::vector<TouchPoint> touches_;
};

}  // namespace openr_host
