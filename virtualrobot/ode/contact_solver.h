// One step of an ODE world with Coulomb contacts; contacts that stick cost little.
//
// ODE's exact solver treats a contact as three bounded unknowns and pivots over each of them, which
// takes a third of the time of a step of the standing robot.  A contact that pressed and stuck in
// the last step is therefore first "held": replaced by a ball joint of the same softness, whose
// three unknowns have no bounds.  After the solve every held contact is checked.  When one pulls,
// or its force leaves the friction cone, the bodies are put back and the step is solved again with
// that contact "bounded", as an ordinary contact of ODE.
//
// So held contacts obey Coulomb's law exactly.  For bounded contacts ODE takes the limit of
// friction from normal forces that it found without friction.
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
  bool hold = true;       // false: all contacts are bounded
};

class ContactSolver {
 public:
  // `world` and `bodies` must outlive the solver; `features` as ContactFinder::features().
  ContactSolver(dWorldID world, const std::vector<dBodyID>& bodies, int features,
                const ContactSettings& settings);
  ~ContactSolver();
  ContactSolver(const ContactSolver&) = delete;
  ContactSolver& operator=(const ContactSolver&) = delete;

  // Solves in one step: up to three with held contacts, and one in which all are bounded.
  static constexpr int kSolvesMax = 4;

  // Advances the world by one step with `points` in contact.  `step` adds the outer forces and
  // calls ODE's stepping function.  It is called once for each solve, so up to kSolvesMax times.
  void Step(const std::vector<ContactPoint>& points, const std::function<void()>& step);

  void HashState(Hasher* hasher) const;

 private:
  struct BodyPose {
    dReal position[3], rotation[4], linear[3], angular[3];
  };

  void AddHeld(const ContactPoint& point, dJointFeedback* feedback);
  void AddBounded(const ContactPoint& point, dJointFeedback* feedback);
  void SolveOnce(const std::vector<ContactPoint>& points, const std::function<void()>& step);
  // Whether the contact presses and its force along the ground is inside `share` of the friction
  // cone.
  bool IsSticking(const ContactPoint& point, const dJointFeedback& feedback, double share) const;
  // Whether all held contacts stick.  Those that do not are bounded from now on.
  bool AllHeldStick(const std::vector<ContactPoint>& points);
  void ChooseNext(const std::vector<ContactPoint>& points);
  void Save();
  void Restore();

  dWorldID world_;
  const std::vector<dBodyID>& bodies_;
  ContactSettings settings_;
  dJointGroupID group_;
  std::vector<int8_t> wait_;       // [feature]: steps until its contact may be held; 0: it may
  std::vector<bool> held_;         // [point of this step]
  std::vector<bool> is_sticking_;  // [feature], after this step
  std::vector<dJointFeedback> feedback_;  // [point of this step]: forces that ODE found
  std::vector<BodyPose> saved_;           // [body], before this step
};

}  // namespace openr_host
