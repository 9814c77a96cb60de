#include "virtualrobot/ode/contact_solver.h"

#include <algorithm>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "virtualrobot/ode/ode_vectors.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

// When a held contact (a ball joint) does not stick, it becomes a bounded contact (an ordinary
// contact of ODE) for this number of steps.  Without this wait, a paw that slides or rattles would
// make every step solve its equations twice.
constexpr int8_t kWaitSteps = 16;

// Maximum number of times that the equations of a step are solved with held contacts.  After each
// time, the contacts that did not stick become bounded; after the last time, all contacts become
// bounded.
constexpr int kHeldSolvesMax = 3;
static_assert(kHeldSolvesMax + 1 == ContactSolver::kSolvesMax);

// Share of the friction cone in which the force of a bounded contact must lie for the contact to be
// held in the next step.  It is below 1, because the force of a contact that slides lies on the
// border of the cone.
constexpr double kWellInside = 0.8;

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
  for (const ContactPoint& point : points) {
    ASSERT(point.feature >= 0 && static_cast<size_t>(point.feature) < wait_.size(), "feature {}",
           point.feature);
  }
  held_.assign(points.size(), false);
  for (size_t i = 0; i < points.size(); ++i) {
    held_[i] = settings_.hold && wait_[points[i].feature] == 0;
  }
  // Without a held contact there is nothing to check, so ODE's first result is final.
  const bool any_held = std::find(held_.begin(), held_.end(), true) != held_.end();
  if (any_held) Save();
  SolveOnce(points, step);
  for (int solves = 1; any_held && !AllHeldStick(points); ++solves) {
    ASSERT(solves <= kHeldSolvesMax, "no contact is held any more, yet one does not stick");
    Restore();
    for (size_t i = 0; i < points.size(); ++i) {
      if (solves == kHeldSolvesMax || wait_[points[i].feature] != 0) held_[i] = false;
    }
    SolveOnce(points, step);
  }
  ChooseNext(points);
}

// Chooses the features (places of the robot that can touch) whose contacts may be held in the next
// step: the features that stick in this step.  A feature that slides or does not touch must first
// stick in a step in which its contact is bounded.
void ContactSolver::ChooseNext(const std::vector<ContactPoint>& points) {
  is_sticking_.assign(wait_.size(), false);
  for (size_t i = 0; i < points.size(); ++i) {
    is_sticking_[points[i].feature] = IsSticking(points[i], feedback_[i], kWellInside);
  }
  for (size_t k = 0; k < wait_.size(); ++k) {
    if (wait_[k] > 1) {
      wait_[k] -= 1;
    } else {
      wait_[k] = is_sticking_[k] ? 0 : 1;
    }
  }
}

void ContactSolver::SolveOnce(const std::vector<ContactPoint>& points,
                              const std::function<void()>& step) {
  feedback_.resize(points.size());  // before the loop, because joints keep pointers to its elements
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

// Makes a ball joint between the point of the body and the point of the ground above it.  Because
// the error of the joint is the depth along the normal, erp and cfm mean the same as for a contact.
// Along the ground the error is zero, and cfm acts like the slip of a contact.
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

bool ContactSolver::IsSticking(const ContactPoint& point, const dJointFeedback& feedback,
                               double share) const {
  const Vector3d force = ToEigen(feedback.f1);
  const double press = force.dot(point.normal_W);
  const double along2 = (force - press * point.normal_W).squaredNorm();
  const double limit = share * settings_.friction * press;
  return press > 0 && along2 <= limit * limit;
}

bool ContactSolver::AllHeldStick(const std::vector<ContactPoint>& points) {
  bool all = true;
  for (size_t i = 0; i < points.size(); ++i) {
    if (!held_[i] || IsSticking(points[i], feedback_[i], 1)) continue;
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
