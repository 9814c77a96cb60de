#include "virtualrobot/ode/contact_solver.h"

#include <algorithm>

#include "runtime/base/hasher.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

// After a contact turned out not to hold, it is solved with bounds for this many steps
// more, so that a paw that slides or rattles does not cost two solves each time.
constexpr int8_t kWaitSteps = 16;

// Solves with held contacts before all are bounded: those that fail are let go each time.
constexpr int kTriesMax = 3;

// A bounded contact is held next when its force lies inside this share of the cone.  One
// that slides lies on the border.
constexpr double kWellInside = 0.8;

Vector3d ToEigen(const dReal* v) { return {v[0], v[1], v[2]}; }

}  // namespace

ContactSolver::ContactSolver(dWorldID world, const std::vector<dBodyID>& bodies, int features,
                             const ContactSettings& settings)
    : world_(world),
      bodies_(bodies),
      settings_(settings),
      group_(dJointGroupCreate(0)),
      wait_(features, 1),
      saved_(bodies.size()) {}

ContactSolver::~ContactSolver() { dJointGroupDestroy(group_); }

void ContactSolver::Step(const std::vector<ContactPoint>& points,
                         const std::function<void()>& step) {
  held_.assign(points.size(), false);
  for (size_t i = 0; i < points.size(); ++i) {
    held_[i] = settings_.hold && wait_[points[i].feature] == 0;
  }
  const bool any_held = std::find(held_.begin(), held_.end(), true) != held_.end();
  if (any_held) Save();
  SolveOnce(points, step);
  for (int tries = 1; any_held && !HeldOnesStick(points); ++tries) {
    Restore();
    for (size_t i = 0; i < points.size(); ++i) {
      if (tries == kTriesMax || wait_[points[i].feature] != 0) held_[i] = false;
    }
    SolveOnce(points, step);
  }
  ChooseNext(points);
}

// What is not in contact, or slides, must stick for one bounded step before it is held.
void ContactSolver::ChooseNext(const std::vector<ContactPoint>& points) {
  sticks_.assign(wait_.size(), false);
  for (size_t i = 0; i < points.size(); ++i) {
    sticks_[points[i].feature] = Sticks(points[i], feedback_[i], kWellInside);
  }
  for (size_t k = 0; k < wait_.size(); ++k) {
    if (wait_[k] > 1) {
      wait_[k] -= 1;
    } else {
      wait_[k] = sticks_[k] ? 0 : 1;
    }
  }
}

void ContactSolver::SolveOnce(const std::vector<ContactPoint>& points,
                              const std::function<void()>& step) {
  feedback_.resize(points.size());  // before the joints point into it
  for (size_t i = 0; i < points.size(); ++i) {
    if (held_[i]) {
      AddHeld(points[i], &feedback_[i]);
    } else {
      AddBounded(points[i], &feedback_[i]);
    }
  }
  step();
  dJointGroupEmpty(group_);
}

// The ball's error is the depth along the normal, so erp and cfm mean what they mean for a
// contact; along the ground its error is zero and cfm is the contact's slip.
void ContactSolver::AddHeld(const ContactPoint& point, dJointFeedback* feedback) {
  const Vector3d out = point.p_W + point.depth_m * point.normal_W;
  const dJointID joint = dJointCreateBall(world_, group_);
  dJointAttach(joint, bodies_[point.body], nullptr);
  dJointSetBallAnchor(joint, point.p_W.x(), point.p_W.y(), point.p_W.z());
  dJointSetBallAnchor2(joint, out.x(), out.y(), out.z());
  dJointSetBallParam(joint, dParamERP, settings_.erp);
  dJointSetBallParam(joint, dParamCFM, settings_.cfm);
  dJointSetFeedback(joint, feedback);
}

void ContactSolver::AddBounded(const ContactPoint& point, dJointFeedback* feedback) {
  dContact contact = {};
  contact.surface.mode =
      dContactApprox1 | dContactSoftERP | dContactSoftCFM | dContactSlip1 | dContactSlip2;
  contact.surface.mu = settings_.friction;
  contact.surface.soft_erp = settings_.erp;
  contact.surface.soft_cfm = settings_.cfm;
  contact.surface.slip1 = settings_.cfm;
  contact.surface.slip2 = settings_.cfm;
  for (int k = 0; k < 3; ++k) {
    contact.geom.pos[k] = point.p_W[k];
    contact.geom.normal[k] = point.normal_W[k];
  }
  contact.geom.depth = point.depth_m;
  const dJointID joint = dJointCreateContact(world_, group_, &contact);
  dJointAttach(joint, bodies_[point.body], nullptr);
  dJointSetFeedback(joint, feedback);
}

// Whether the contact presses and its force along the ground is inside `share` of the cone.
bool ContactSolver::Sticks(const ContactPoint& point, const dJointFeedback& feedback,
                           double share) const {
  const Vector3d force = ToEigen(feedback.f1);
  const double press = force.dot(point.normal_W);
  const double along2 = (force - press * point.normal_W).squaredNorm();
  const double limit = share * settings_.friction * press;
  return press > 0 && along2 <= limit * limit;
}

bool ContactSolver::HeldOnesStick(const std::vector<ContactPoint>& points) {
  bool all = true;
  for (size_t i = 0; i < points.size(); ++i) {
    if (!held_[i] || Sticks(points[i], feedback_[i], 1)) continue;
    wait_[points[i].feature] = kWaitSteps;
    all = false;
  }
  return all;
}

void ContactSolver::Save() {
  for (size_t i = 0; i < bodies_.size(); ++i) {
    BodyPose& pose = saved_[i];
    std::copy_n(dBodyGetPosition(bodies_[i]), 3, pose.position);
    std::copy_n(dBodyGetQuaternion(bodies_[i]), 4, pose.rotation);
    std::copy_n(dBodyGetLinearVel(bodies_[i]), 3, pose.linear);
    std::copy_n(dBodyGetAngularVel(bodies_[i]), 3, pose.angular);
  }
}

void ContactSolver::Restore() {
  for (size_t i = 0; i < bodies_.size(); ++i) {
    const BodyPose& pose = saved_[i];
    dBodySetPosition(bodies_[i], pose.position[0], pose.position[1], pose.position[2]);
    dBodySetQuaternion(bodies_[i], pose.rotation);
    dBodySetLinearVel(bodies_[i], pose.linear[0], pose.linear[1], pose.linear[2]);
    dBodySetAngularVel(bodies_[i], pose.angular[0], pose.angular[1], pose.angular[2]);
  }
}

void ContactSolver::HashState(Hasher* hasher) const {
  hasher->AddBytes(wait_.data(), wait_.size());
}

}  // namespace openr_host
