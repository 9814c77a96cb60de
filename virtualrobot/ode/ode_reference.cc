#include "virtualrobot/ode/ode_reference.h"

#include <ode/ode.h>

#include <algorithm>

#include "runtime/base/upper_registers.h"
#include "virtualrobot/body/kinematics.h"
#include "virtualrobot/ode/contact_finder.h"
#include "virtualrobot/ode/ode_bodies.h"
#include "virtualrobot/ode/ode_body.h"

namespace openr_host {

using Eigen::Isometry3d;
using Eigen::Vector3d;

OdeReference::OdeReference(const RobotModel& model, const World& world, const Isometry3d& X_WB,
                           const std::vector<double>& angles_rad)
    : surroundings_(world), start_rad_(angles_rad) {
  const OdeSettings settings;
  InitOde();
  world_ = dWorldCreate();
  contacts_ = dJointGroupCreate(0);
  dWorldSetGravity(world_, 0, 0, -kGravity_m_s2);
  dWorldSetERP(world_, 0.2);
  dWorldSetCFM(world_, 1e-9);
  // Forbids ODE to leave out bodies that are at rest, because OdeBody, with which this robot is
  // compared, computes bodies at rest, too.
  dWorldSetAutoDisableFlag(world_, 0);
  dWorldSetContactMaxCorrectingVel(world_, settings.depart_speed_m_s);
  const std::vector<Isometry3d> X_BL = LinkPoses(model, angles_rad);
  for (size_t i = 0; i < model.bodies.size(); ++i) {
    const Isometry3d X_WL = X_WB * X_BL[i];
    bodies_.push_back(MakeBody(world_, model.bodies[i]));
    PlaceBody(bodies_[i], X_WL * model.bodies[i].centre_m, X_WL.linear());
  }
  for (const JointModel& joint : model.joints) {
    const dJointID hinge = dJointCreateHinge(world_, nullptr);
    dJointAttach(hinge, bodies_[joint.child], bodies_[joint.parent]);
    const Isometry3d X_WL = X_WB * X_BL[joint.child];
    const Vector3d anchor = X_WL * joint.anchor_m, axis = X_WL.linear() * joint.axis;
    dJointSetHingeAnchor(hinge, anchor.x(), anchor.y(), anchor.z());
    dJointSetHingeAxis(hinge, axis.x(), axis.y(), axis.z());
    // Sets no limit to the torque, because the parameters vel and cfm alone give the torque of the
    // servo.
    dJointSetHingeParam(hinge, dParamFMax, dInfinity);
    hinges_.push_back(hinge);
    servos_.emplace_back(joint, settings.servo);
  }
  finder_ = std::make_unique<ContactFinder>(surroundings_.things,
                                            std::vector<dBodyID>(surroundings_.things.size()));
  finder_->AddRobot(0, model, bodies_);
}

OdeReference::~OdeReference() {
  finder_.reset();
  dJointGroupDestroy(contacts_);
  dWorldDestroy(world_);  // destroys the world with its bodies and hinges
}

void OdeReference::Advance(const std::vector<JointCommand>& commands) {
  for (size_t j = 0; j < servos_.size(); ++j) {
    const double angle = angle_rad(static_cast<int>(j));
    servos_[j].BeginFrame(commands[j], angle);
    const TorqueLine line = servos_[j].Step(angle, speed_rad_s(static_cast<int>(j)), kFrame_s);
    dJointSetHingeParam(hinges_[j], dParamVel, line.zero_speed_nm / line.slope_nm_s);
    dJointSetHingeParam(hinges_[j], dParamCFM, 1 / line.slope_nm_s);
  }
  AddContacts();
  ClearUpperRegisters();
  dWorldStep(world_, kFrame_s);
  dJointGroupEmpty(contacts_);
}

void OdeReference::AddContacts() {
  const OdeSettings settings;
  for (const ContactPoint& point : finder_->Find()) {
    dContact contact{};
    contact.surface.mode =
        dContactSoftERP | dContactSoftCFM | dContactSlip1 | dContactSlip2 | dContactApprox1;
    contact.surface.mu = surroundings_.floor_friction;
    contact.surface.soft_erp = settings.contact_erp;
    contact.surface.soft_cfm = settings.contact_cfm;
    contact.surface.slip1 = contact.surface.slip2 = settings.contact_cfm;
    std::copy_n(point.p_W.data(), 3, contact.geom.pos);
    std::copy_n(point.normal_W.data(), 3, contact.geom.normal);
    contact.geom.depth = point.depth_m;
    dJointAttach(dJointCreateContact(world_, contacts_, &contact), bodies_[point.side.part],
                 nullptr);
  }
}

void OdeReference::Push(int part, const Vector3d& force_W, const Vector3d& p_W) {
  dBodyAddForceAtPos(bodies_[part], force_W.x(), force_W.y(), force_W.z(), p_W.x(), p_W.y(),
                     p_W.z());
}

// Takes the angle from ODE, which calls atan2 of libm, so its bits depend on the processor.  This
// is good enough, because OdeReference serves only for comparisons with our own simulation.
double OdeReference::angle_rad(int joint) const {
  return start_rad_[joint] + dJointGetHingeAngle(hinges_[joint]);
}

double OdeReference::speed_rad_s(int joint) const {
  return dJointGetHingeAngleRate(hinges_[joint]);
}

Vector3d OdeReference::centre_W(int part) const { return ToEigen(dBodyGetPosition(bodies_[part])); }

Vector3d OdeReference::v_W(int part) const { return ToEigen(dBodyGetLinearVel(bodies_[part])); }

Vector3d OdeReference::w_W(int part) const { return ToEigen(dBodyGetAngularVel(bodies_[part])); }

}  // namespace openr_host
