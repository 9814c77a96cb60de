#include "virtualrobot/ode/ode_body.h"

#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <stdexcept>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/base/upper_registers.h"
#include "virtualrobot/kinematics.h"
#include "virtualrobot/ode/contact_finder.h"
#include "virtualrobot/ode/contact_solver.h"
#include "virtualrobot/ode/ode_process.h"
#include "virtualrobot/ode/ode_vectors.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Numbers of a hand that holds the trunk (our choices): the time in which it follows, and its
// limits of speed, force and torque.
constexpr double kHandTime_s = 0.05;
constexpr double kHandSpeed_m_s = 0.5, kHandTurn_rad_s = 2;
constexpr double kHandForce_n = 60, kHandTorque_nm = 5;

// Returns `vector`, shortened to the length `max` if it is longer.
Vector3d Limited(const Vector3d& vector, double max) {
  const double length = vector.norm();
  return length > max ? Vector3d(vector * (max / length)) : vector;
}

// Throws std::runtime_error when a part or a joint of the model lacks what physics needs: box, mass
// or torque.
void RefuseUnlessPhysical(const RobotModel& model) {
  for (const BodyPart& body : model.bodies) {
    if (!body.has_box || !(body.mass_kg > 0)) {
      throw std::runtime_error(
          fmt::format("{}: no ODE body: part '{}' has no {} in the model file; use --body ideal",
                      model.name, body.name, body.has_box ? "mass" : "box"));
    }
  }
  for (const JointModel& joint : model.joints) {
    if (!(joint.stall_torque_nm > 0)) {
      throw std::runtime_error(
          fmt::format("{}: no ODE body: joint '{}' has no torque in the model file; use "
                      "--body ideal",
                      model.name, joint.name));
    }
  }
}

}  // namespace

OdeBody::OdeBody(const RobotModel& model, const World& world, const OdeSettings& settings)
    : model_(model), surroundings_(world), settings_(settings) {
  RefuseUnlessPhysical(model);
  InitOde();
  world_ = dWorldCreate();
  dWorldSetGravity(world_, 0, 0, -kGravity_m_s2);
  dWorldSetERP(world_, settings.joint_erp);
  dWorldSetCFM(world_, settings.joint_cfm);
  dWorldSetAutoDisableFlag(world_, 0);  // a robot that lies still must react to commands
  dWorldSetContactMaxCorrectingVel(world_, settings.depart_speed_m_s);
  dWorldSetQuickStepNumIterations(world_, settings.quick_iterations);

  const std::vector<double>& angles_rad = model.PostureAngles("sleep");
  const RestingPose pose = PlaceOnFloor(model, angles_rad);
  const std::vector<Isometry3d> X_BL = LinkPoses(model, angles_rad);
  MakeBodies(pose, X_BL);
  MakeHinges(pose, X_BL);

  finder_ = std::make_unique<ContactFinder>(model, surroundings_, bodies_);
  solver_ =
      std::make_unique<ContactSolver>(world_, bodies_, finder_->features(),
                                      ContactSettings{.friction = surroundings_.floor_friction,
                                                      .erp = settings.contact_erp,
                                                      .cfm = settings.contact_cfm,
                                                      .hold = settings.hold_contacts});
  state_.joints.resize(model.joints.size());
  ReadState();
  state_.paws = pose.paws;
  state_.gravity_B = state_.X_WB.linear().transpose() * Vector3d(0, 0, -kGravity_m_s2);
}

OdeBody::~OdeBody() {
  // The solver and the finder are destroyed first, because they refer to bodies of the world.
  solver_.reset();
  finder_.reset();
  dWorldDestroy(world_);  // also destroys its bodies and hinges
}

void OdeBody::MakeBodies(const RestingPose& pose, const std::vector<Isometry3d>& X_BL) {
  for (size_t i = 0; i < model_.bodies.size(); ++i) {
    const BodyPart& part = model_.bodies[i];
    // The mass has uniform density inside the bounding box (Hohl 2004, section 3.1.3).
    dMass mass;
    dMassSetBoxTotal(&mass, part.mass_kg, part.size_m.x(), part.size_m.y(), part.size_m.z());
    const dBodyID body = dBodyCreate(world_);
    dBodySetMass(body, &mass);
    const Isometry3d X_WL = pose.X_WB * X_BL[i];
    const Vector3d p = X_WL * part.centre_m;
    const Matrix3d& R = X_WL.linear();
    const dMatrix3 rotation = {R(0, 0), R(0, 1), R(0, 2), 0,       R(1, 0), R(1, 1),
                               R(1, 2), 0,       R(2, 0), R(2, 1), R(2, 2), 0};
    dBodySetPosition(body, p.x(), p.y(), p.z());
    dBodySetRotation(body, rotation);
    bodies_.push_back(body);
  }
}

void OdeBody::MakeHinges(const RestingPose& pose, const std::vector<Isometry3d>& X_BL) {
  for (const JointModel& joint : model_.joints) {
    const dJointID hinge = dJointCreateHinge(world_, nullptr);
    dJointAttach(hinge, bodies_[joint.child], bodies_[joint.parent]);
    const Isometry3d X_WL = pose.X_WB * X_BL[joint.child];
    const Vector3d anchor = X_WL * joint.anchor_m, axis = X_WL.linear() * joint.axis;
    dJointSetHingeAnchor(hinge, anchor.x(), anchor.y(), anchor.z());
    dJointSetHingeAxis(hinge, axis.x(), axis.y(), axis.z());
    // The motor of the hinge has no torque limit of its own, because the torque line that Step()
    // sets has the limits of the servo already.
    dJointSetHingeParam(hinge, dParamFMax, dInfinity);
    hinges_.push_back(hinge);
    axes_.push_back(HingeAxisOf(joint));
    servos_.emplace_back(joint, settings_.servo);
  }
}

void OdeBody::Advance(const std::vector<JointCommand>& commands) {
  ASSERT(commands.size() == servos_.size(), "{} commands for {} joints", commands.size(),
         servos_.size());
  const Vector3d v_before_W = state_.v_WB;
  for (size_t j = 0; j < servos_.size(); ++j) {
    servos_[j].BeginFrame(commands[j], state_.joints[j].angle_rad);
  }
  state_.paws.assign(model_.paws.size(), false);
  for (int i = 0; i < settings_.steps_per_frame; ++i) Step(kFrame_s / settings_.steps_per_frame);
  pushes_.clear();
  for (size_t j = 0; j < servos_.size(); ++j) {
    JointState& joint = state_.joints[j];
    joint.drive = servos_[j].Drive(joint.angle_rad, joint.speed_rad_s);
  }
  const Vector3d acceleration_W = (state_.v_WB - v_before_W) / kFrame_s;  // averaged over the frame
  state_.gravity_B =
      state_.X_WB.linear().transpose() * (Vector3d(0, 0, -kGravity_m_s2) - acceleration_W);
}

// Advances the robot by one step of `step_s` seconds.
//
// A servo's torque t falls with the speed v of the joint: t = t0 - b v.  The motor of an ODE hinge
// obeys v = vel - cfm * t, so vel = t0 / b and cfm = 1 / b make the motor behave like the servo.
// ODE then finds t together with all other forces, for the speed v at the end of the step.
void OdeBody::Step(double step_s) {
  for (size_t j = 0; j < servos_.size(); ++j) {
    const TorqueLine line =
        servos_[j].Step(state_.joints[j].angle_rad, state_.joints[j].speed_rad_s, step_s);
    dJointSetHingeParam(hinges_[j], dParamVel, line.zero_speed_nm / line.slope_nm_s);
    dJointSetHingeParam(hinges_[j], dParamCFM, 1 / line.slope_nm_s);
  }
  const std::vector<ContactPoint>& points = finder_->Find();
  solver_->Step(points, [this, step_s] { SolveStep(step_s); });
  for (const ContactPoint& point : points) {
    if (point.paw >= 0) state_.paws[point.paw] = true;
  }
  ReadState();
}

void OdeBody::SolveStep(double step_s) {
  for (const PushForce& push : pushes_) {
    dBodyAddForceAtPos(bodies_[push.part], push.force_W.x(), push.force_W.y(), push.force_W.z(),
                       push.p_W.x(), push.p_W.y(), push.p_W.z());
  }
  if (held_at_) PullByHand(step_s);
  const OdeRandomScope random(&random_seed_);
  // Without this call, libode, which is SSE code, runs at a third of its speed after AVX code.
  ClearUpperRegisters();
  if (settings_.solver == OdeSettings::Solver::kExact) {
    dWorldStep(world_, step_s);
  } else {
    dWorldQuickStep(world_, step_s);
  }
}

void OdeBody::ReadState() {
  for (size_t j = 0; j < servos_.size(); ++j) {
    const JointModel& joint = model_.joints[j];
    const dBodyID parent = bodies_[joint.parent], child = bodies_[joint.child];
    state_.joints[j].angle_rad = MeasureAngle(axes_[j], parent, child);
    state_.joints[j].speed_rad_s = MeasureSpeed(axes_[j], parent, child);
  }
  const Matrix3d R = RotationOf(bodies_[0]);
  const Vector3d centre_W = R * model_.bodies[0].centre_m;  // from B's origin, with the axes of W
  state_.X_WB.linear() = R;
  state_.X_WB.translation() = ToEigen(dBodyGetPosition(bodies_[0])) - centre_W;
  state_.w_WB = ToEigen(dBodyGetAngularVel(bodies_[0]));
  state_.v_WB = ToEigen(dBodyGetLinearVel(bodies_[0])) - state_.w_WB.cross(centre_W);
}

Isometry3d OdeBody::PoseOf(int body) const {
  Isometry3d X_WL;
  X_WL.linear() = RotationOf(bodies_[body]);
  X_WL.translation() =
      ToEigen(dBodyGetPosition(bodies_[body])) - X_WL.linear() * model_.bodies[body].centre_m;
  X_WL.makeAffine();
  return X_WL;
}

std::vector<Isometry3d> OdeBody::BodyPoses() const {
  std::vector<Isometry3d> X_WL;
  for (size_t i = 0; i < bodies_.size(); ++i) X_WL.push_back(PoseOf(static_cast<int>(i)));
  return X_WL;
}

double OdeBody::RayDistance(const Vector3d& p_W, const Vector3d& direction_W, double max_m) const {
  return openr_host::RayDistance(surroundings_, p_W, direction_W, max_m);
}

double OdeBody::HingeError() const {
  double error_m = 0;
  for (const dJointID hinge : hinges_) {
    dVector3 end1, end2;
    dJointGetHingeAnchor(hinge, end1);
    dJointGetHingeAnchor2(hinge, end2);
    error_m = std::max(error_m, (ToEigen(end1) - ToEigen(end2)).norm());
  }
  return error_m;
}

void OdeBody::HashState(Hasher* hasher) const {
  HashWorld(surroundings_, hasher);
  // All numbers are collected first, because hashing one long run of bytes is faster than hashing
  // many short ones.
  std::vector<double> values;
  values.reserve(13 * bodies_.size() + 3);
  for (const dBodyID body : bodies_) {
    values.insert(values.end(), dBodyGetPosition(body), dBodyGetPosition(body) + 3);
    values.insert(values.end(), dBodyGetQuaternion(body), dBodyGetQuaternion(body) + 4);
    values.insert(values.end(), dBodyGetLinearVel(body), dBodyGetLinearVel(body) + 3);
    values.insert(values.end(), dBodyGetAngularVel(body), dBodyGetAngularVel(body) + 3);
  }
  values.insert(values.end(), state_.gravity_B.data(), state_.gravity_B.data() + 3);
  hasher->AddBytes(values.data(), values.size() * sizeof(double));
  for (const bool touches : state_.paws) hasher->Add(touches);
  for (const Servo& servo : servos_) servo.HashState(hasher);
  solver_->HashState(hasher);
  hasher->Add(random_seed_);
  for (const PushForce& push : pushes_) {
    hasher->Add(push.part);
    hasher->AddBytes(push.force_W.data(), 3 * sizeof(double));
    hasher->AddBytes(push.p_W.data(), 3 * sizeof(double));
  }
  if (held_at_) hasher->AddBytes(held_at_->data(), 16 * sizeof(double));
}

void OdeBody::Push(int part, const Vector3d& force_W, const Vector3d& p_W) {
  ASSERT(part >= 0 && static_cast<size_t>(part) < bodies_.size(), "no part {}", part);
  pushes_.push_back({part, force_W, p_W});
}

void OdeBody::Hold(const std::optional<Isometry3d>& X_WB) { held_at_ = X_WB; }

// Adds the force and the torque of a hand that holds the trunk.  The hand carries the weight of the
// robot at its centre of mass.  It also moves the trunk towards held_at_: the wanted speed is the
// distance divided by kHandTime_s, up to a limit.  The force is half of what would give the trunk
// this speed in one step, because the legs and the head hang on the trunk and resist.
void OdeBody::PullByHand(double step_s) {
  const dBodyID trunk = bodies_[0];
  const double mass_kg = model_.TotalMassKg();
  Vector3d centre_W = Vector3d::Zero();
  for (size_t i = 0; i < bodies_.size(); ++i)
    centre_W += ToEigen(dBodyGetPosition(bodies_[i])) * (model_.bodies[i].mass_kg / mass_kg);
  dBodyAddForceAtPos(trunk, 0, 0, mass_kg * kGravity_m_s2, centre_W.x(), centre_W.y(),
                     centre_W.z());

  const Vector3d v_wanted_W =
      Limited((held_at_->translation() - state_.X_WB.translation()) / kHandTime_s, kHandSpeed_m_s);
  const Vector3d force_W =
      Limited((v_wanted_W - state_.v_WB) * (0.5 * model_.bodies[0].mass_kg / step_s), kHandForce_n);
  dBodyAddForce(trunk, force_W.x(), force_W.y(), force_W.z());

  // If the rotation from the present to the wanted orientation is small, half the sum of the cross
  // products of their axes is the rotation's axis times its angle.
  const Matrix3d R = state_.X_WB.linear();
  Vector3d turn_W = Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis)
    turn_W += 0.5 * R.col(axis).cross(held_at_->linear().col(axis));
  const Vector3d w_wanted_W = Limited(turn_W / kHandTime_s, kHandTurn_rad_s);
  dMass mass;
  dBodyGetMass(trunk, &mass);
  Matrix3d inertia_B;
  inertia_B << mass.I[0], mass.I[1], mass.I[2], mass.I[4], mass.I[5], mass.I[6], mass.I[8],
      mass.I[9], mass.I[10];
  const Vector3d torque_W =
      Limited(R * (inertia_B * (R.transpose() * (w_wanted_W - state_.w_WB))) * (0.5 / step_s),
              kHandTorque_nm);
  dBodyAddTorque(trunk, torque_W.x(), torque_W.y(), torque_W.z());
}

std::unique_ptr<Body> MakeOdeBody(const RobotModel& model, const World& world) {
  return std::make_unique<OdeBody>(model, world);
}

}  // namespace openr_host
