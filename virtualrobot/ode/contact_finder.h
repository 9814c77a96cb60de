// Finds the points at which paws and boxes of a robot touch the floor and the static boxes of its
// world.
//
// Our own code tests each part against the floor.  Parts are not tested against each other
// (docs/body.md says why), so ODE's collision spaces are not needed.  Static boxes go through ODE's
// box and sphere colliders.
#pragma once

#include <ode/ode.h>

#include <Eigen/Core>
#include <vector>

#include "virtualrobot/body.h"

namespace openr_host {

struct ContactPoint {
  // Number of the paw, or of the corner of a part's box, that touches: 0 to
  // ContactFinder::features() - 1.  The same place of the robot has the same number in every step.
  int feature = 0;
  int body = -1;  // index in RobotModel::bodies
  int paw = -1;   // index of the paw, -1 for a box
  Eigen::Vector3d p_W{0, 0, 0};
  Eigen::Vector3d normal_W{0, 0, 1};  // out of the ground
  double depth_m = 0;                 // >= 0
};

class ContactFinder {
 public:
  // `bodies` are the ODE bodies of `model`, in order; they must outlive the finder.
  ContactFinder(const RobotModel& model, const World& world, const std::vector<dBodyID>& bodies);
  ~ContactFinder();
  ContactFinder(const ContactFinder&) = delete;
  ContactFinder& operator=(const ContactFinder&) = delete;

  // Number of features: paws first, then 8 corners per body.
  int features() const;

  // All points that touch now, in the order of the model.  Valid until the next call.
  const std::vector<ContactPoint>& Find();

 private:
  void FindPawOnFloor(int paw);
  void FindBoxOnFloor(int body);

  // Finds where part `body` touches the static boxes; where its paw `paw` does when that is not -1.
  void FindOnStaticBoxes(int body, int paw);

  const RobotModel& model_;
  const std::vector<dBodyID>& bodies_;
  std::vector<ContactPoint> points_;
  std::vector<dGeomID> world_boxes_;
  std::vector<dGeomID> part_boxes_;  // one for each body; empty in a world without static boxes
  std::vector<dGeomID> paw_balls_;   // one for each paw; empty in a world without static boxes
};

}  // namespace openr_host
