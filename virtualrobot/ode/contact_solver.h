// One step of an ODE world with Coulomb contacts, without paying for contacts that hold.
//
// ODE's exact solver handles a contact as three bounded unknowns and pivots over each of
// them; that is a third of a step of the standing robot.  A contact that pressed and stuck
// in the last step is therefore first taken as held: a ball joint of the same softness,
// whose three unknowns have no bounds.  After the step every held contact is checked; when
// one pulls or leaves the friction cone, the bodies are put back and the step is solved
// again with that contact bounded.  So held contacts obey Coulomb's law to the letter; for
// bounded ones ODE takes the limit from normal forces found without friction.
#pragma once

#include <ode/ode.h>

#include <functional>
#include <vector>

#include "virtualrobot/ode/contact_finder.h"

namespace openr_host {

class Hasher;

struct ContactSettings {
  double friction = 0.6;  // Coulomb coefficient
  double erp = 0.2;       // share of the depth pushed out per step
  double cfm = 2e-3;      // m/s per N, along the normal and along the ground
  bool hold = true;       // false: never take a contact as held
};

class ContactSolver {
 public:
  // `world` and `bodies` must outlive the solver; `features` as ContactFinder::features().
  ContactSolver(dWorldID world, const std::vector<dBodyID>& bodies, int features,
                const ContactSettings& settings);
  ~ContactSolver();
  ContactSolver(const ContactSolver&) = delete;
  ContactSolver& operator=(const ContactSolver&) = delete;

  // Advances the world by one step with `points` in contact.  `step` adds the outer forces
  // and calls ODE's stepping function; it may run twice.
  void Step(const std::vector<ContactPoint>& points, const std::function<void()>& step);

  void HashState(Hasher* hasher) const;

 private:
  struct BodyPose {
    dReal position[3], rotation[4], linear[3], angular[3];
  };

  void AddHeld(const ContactPoint& point, dJointFeedback* feedback);
  void AddBounded(const ContactPoint& point, dJointFeedback* feedback);
  void SolveOnce(const std::vector<ContactPoint>& points, const std::function<void()>& step);
  bool Sticks(const ContactPoint& point, const dJointFeedback& feedback, double share) const;
  bool HeldOnesStick(const std::vector<ContactPoint>& points);
  void ChooseNext(const std::vector<ContactPoint>& points);
  void Save();
  void Restore();

  dWorldID world_;
  const std::vector<dBodyID>& bodies_;
  ContactSettings settings_;
  dJointGroupID group_;
  std::vector<int8_t> wait_;  // [feature]: steps until it may be held; 0: may
  std::vector<bool> held_;    // of the points of this step
  std::vector<bool> sticks_;  // [feature] after this step
  std::vector<dJointFeedback> feedback_;
  std::vector<BodyPose> saved_;
};

}  // namespace openr_host
