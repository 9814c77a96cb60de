// Where paws and boxes of a robot touch the floor and the static boxes of its world.
//
// The floor is tested by hand, part by part: no collision space, no pairs among the parts
// (docs/body.md says why parts do not collide with each other).  Static boxes go through
// ODE's box and sphere colliders.
#pragma once

#include <ode/ode.h>

#include <Eigen/Core>
#include <vector>

#include "virtualrobot/body.h"

namespace openr_host {

struct ContactPoint {
  int feature =
      0;  // which paw or which corner of which box touches; below ContactFinder::features()
  int body = -1;
  int paw = -1;  // index of the paw, -1 for a box
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

  // Replaces *points by what touches now, in the order of the model.
  void Find(std::vector<ContactPoint>* points) const;

 private:
  void FindPawOnFloor(int paw, std::vector<ContactPoint>* points) const;
  void FindBoxOnFloor(int body, std::vector<ContactPoint>* points) const;
  void FindOnBoxes(int body, int paw, std::vector<ContactPoint>* points) const;

  const RobotModel& model_;
  const std::vector<dBodyID>& bodies_;
  std::vector<dGeomID> world_boxes_;
  std::vector<dGeomID> part_boxes_;  // of the bodies; empty without static boxes
  std::vector<dGeomID> paw_balls_;   // of the paws; empty without static boxes
};

}  // namespace openr_host
