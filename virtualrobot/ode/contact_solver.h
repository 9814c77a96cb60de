// Computes a step of an ODE world with contacts that obey Coulomb's law of friction.  This takes
// less time than ODE's own solver when most contacts stick, that is, do not slide.
//
// ODE's exact solver treats a contact as three bounded unknowns and pivots over each of them, which
// takes a third of the time of a step of the standing robot.  So a contact that pressed and stuck
// in the last step is first "held": a ball joint of the same softness replaces it, whose three
// unknowns have no bounds.  After the equations are solved, every held contact is checked.  When a
// held contact pulls, or its force leaves the friction cone, the bodies are put back and the step
// is solved again.  This time the contact is "bounded", that is, an ordinary contact of ODE.
//
// Therefore held contacts obey Coulomb's law exactly.  For bounded contacts, ODE computes the limit
// of friction from normal forces that it found without friction.
#pragma once

#include <ode/ode.h>

#include <functional>
#include <vector>

#include "virtualrobot/ode/contact_finder.h"

namespace openr_host {

class Hasher;

struct ContactSettings {
  double friction = 0.6;  // Coulomb friction coefficient
  double erp = 0.2;       // share of the penetration depth that is corrected in one step
  double cfm = 2e-3;      // softness, in m/s per N, along the normal and along the ground
  bool hold = true;       // false: no contact is held, all are bounded
};

class ContactSolver {
 public:
  // Makes a solver for the bodies `bodies` of `world`; both must outlive the solver.  `features` is
  // the result of ContactFinder::features().
  ContactSolver(dWorldID world, const std::vector<dBodyID>& bodies, int features,
                const ContactSettings& settings);
  ~ContactSolver();
  ContactSolver(const ContactSolver&) = delete;
  ContactSolver& operator=(const ContactSolver&) = delete;

  // Maximum number of times that the equations are solved in one step: three times with held
  // contacts, and once more with all contacts bounded.
  static constexpr int kSolvesMax = 4;

  // Advances the world by one step with `points` in contact.  `step` adds the outer forces and
  // calls ODE's stepping function.  The solver calls `step` once each time it solves the equations,
  // up to kSolvesMax times.
  void Step(const std::vector<ContactPoint>& points, const std::function<void()>& step);

  void HashState(Hasher* hasher) const;

 private:
  struct BodyPose {
    dReal position[3], rotation[4], linear[3], angular[3];
  };

  void AddHeld(const ContactPoint& point, dJointFeedback* feedback);
  void AddBounded(const ContactPoint& point, dJointFeedback* feedback);
  void SolveOnce(const std::vector<ContactPoint>& points, const std::function<void()>& step);
  // Returns whether the contact presses and its force along the ground is inside `share` (0 to 1)
  // of the friction cone.
  bool IsSticking(const ContactPoint& point, const dJointFeedback& feedback, double share) const;
  // Returns whether all held contacts stick.  Contacts that do not stick are bounded from now on.
  bool AllHeldStick(const std::vector<ContactPoint>& points);
  void ChooseNext(const std::vector<ContactPoint>& points);
  void Save();
  void Restore();

  dWorldID world_;
  const std::vector<dBodyID>& bodies_;
  ContactSettings settings_;
  dJointGroupID group_;
  std::vector<int8_t> wait_;              // [feature]: steps until a contact may be held; 0: it may
  std::vector<bool> held_;                // [point of this step]: whether the contact is held
  std::vector<bool> is_sticking_;         // [feature]: whether the place sticks after this step
  std::vector<dJointFeedback> feedback_;  // [point of this step]: forces found by ODE
  std::vector<BodyPose> saved_;           // [body]: pose and velocity before this step
};

}  // namespace openr_host
