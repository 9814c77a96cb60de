#include "virtualrobot/ode/ode_body.h"

#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <stdexcept>

#include "runtime/base/hasher.h"
#include "runtime/base/upper_registers.h"
#include "virtualrobot/kinematics.h"
#include "virtualrobot/ode/contact_finder.h"
#include "virtualrobot/ode/contact_solver.h"
#include "virtualrobot/ode/hinge_measure.h"
#include "virtualrobot/ode/ode_process.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d ToEigen(const dReal* v) { return {v[0], v[1], v[2]}; }

Matrix3d RotationOf(dBodyID body) {
  const dReal* r = dBodyGetRotation(body);
  Matrix3d R;
  R << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
  return R;
}

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

class OdeBody::Impl {
 public:
  Impl(const RobotModel& model, const World& world, const OdeSettings& settings);
  ~Impl();

  void Advance(const std::vector<JointCommand>& commands);
  void HashState(Hasher* hasher) const;
  Isometry3d PoseOf(int body) const;
  double HingeError() const;

  struct PushForce {
    int body;
    Vector3d force_W, p_W;
  };
  std::vector<PushForce> pushes;
  BodyState state;
  const World world;
  const std::vector<dBodyID>& bodies() const { return bodies_; }

 private:
  void MakeBodies(const RestingPose& pose, const std::vector<Isometry3d>& X_BL);
  void MakeHinges(const RestingPose& pose, const std::vector<Isometry3d>& X_BL);
  void Step(double step_s);
  void SolveStep(double step_s);
  void ReadState();

  const RobotModel& model_;
  const OdeSettings settings_;
  dWorldID world_;
  std::vector<dBodyID> bodies_;
  std::vector<dJointID> hinges_;
  std::vector<HingeAxis> axes_;
  std::vector<Servo> servos_;
  std::unique_ptr<ContactFinder> finder_;
  std::unique_ptr<ContactSolver> solver_;
  std::vector<ContactPoint> points_;
  uint64_t random_seed_ = 1;  // of ODE's generator in this world
};

OdeBody::Impl::Impl(const RobotModel& model, const World& world_in, const OdeSettings& settings)
    : world(world_in), model_(model), settings_(settings) {
  RefuseUnlessPhysical(model);
  InitOde();
  world_ = dWorldCreate();
  dWorldSetGravity(world_, 0, 0, -kGravity_m_s2);
  dWorldSetERP(world_, settings.joint_erp);
  dWorldSetCFM(world_, settings.joint_cfm);
  dWorldSetAutoDisableFlag(world_, 0);
  dWorldSetContactMaxCorrectingVel(world_, settings.depart_speed_m_s);
  dWorldSetQuickStepNumIterations(world_, settings.quick_iterations);

  const std::vector<double>& angles_rad = model.PostureAngles("sleep");
  const RestingPose pose = PlaceOnFloor(model, angles_rad);
  const std::vector<Isometry3d> X_BL = LinkPoses(model, angles_rad);
  MakeBodies(pose, X_BL);
  MakeHinges(pose, X_BL);

  finder_ = std::make_unique<ContactFinder>(model, world, bodies_);
  solver_ = std::make_unique<ContactSolver>(world_, bodies_, finder_->features(),
                                            ContactSettings{.friction = world.floor_friction,
                                                            .erp = settings.contact_erp,
                                                            .cfm = settings.contact_cfm,
                                                            .hold = settings.hold_contacts});
  state.joints.resize(model.joints.size());
  ReadState();
  state.paws = pose.paws;
  state.gravity_B = state.X_WB.linear().transpose() * Vector3d(0, 0, -kGravity_m_s2);
}

OdeBody::Impl::~Impl() {
  solver_.reset();
  finder_.reset();
  dWorldDestroy(world_);  // with its bodies and hinges
}

void OdeBody::Impl::MakeBodies(const RestingPose& pose, const std::vector<Isometry3d>& X_BL) {
  for (size_t i = 0; i < model_.bodies.size(); ++i) {
    const BodyPart& part = model_.bodies[i];
    // Uniform density inside the bounding box (Hohl 2004, section 3.1.3).
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

void OdeBody::Impl::MakeHinges(const RestingPose& pose, const std::vector<Isometry3d>& X_BL) {
  for (const JointModel& joint : model_.joints) {
    const dJointID hinge = dJointCreateHinge(world_, nullptr);
    dJointAttach(hinge, bodies_[joint.child], bodies_[joint.parent]);
    const Isometry3d X_WL = pose.X_WB * X_BL[joint.child];
    const Vector3d anchor = X_WL * joint.anchor_m, axis = X_WL.linear() * joint.axis;
    dJointSetHingeAnchor(hinge, anchor.x(), anchor.y(), anchor.z());
    dJointSetHingeAxis(hinge, axis.x(), axis.y(), axis.z());
    dJointSetHingeParam(hinge, dParamFMax, dInfinity);
    hinges_.push_back(hinge);
    axes_.push_back(HingeAxisOf(joint));
    servos_.emplace_back(joint, settings_.servo);
  }
}

void OdeBody::Impl::Advance(const std::vector<JointCommand>& commands) {
  const Vector3d v_before_W = state.v_WB;
  for (size_t j = 0; j < servos_.size(); ++j) {
    servos_[j].BeginFrame(commands[j], state.joints[j].angle_rad);
  }
  state.paws.assign(model_.paws.size(), false);
  for (int i = 0; i < settings_.steps_per_frame; ++i) Step(kFrame_s / settings_.steps_per_frame);
  pushes.clear();
  for (size_t j = 0; j < servos_.size(); ++j) {
    JointState& joint = state.joints[j];
    joint.drive = servos_[j].Drive(joint.angle_rad, joint.speed_rad_s);
  }
  const Vector3d acceleration_W = (state.v_WB - v_before_W) / kFrame_s;  // mean of the frame
  state.gravity_B =
      state.X_WB.linear().transpose() * (Vector3d(0, 0, -kGravity_m_s2) - acceleration_W);
}

// A servo's torque line t = t0 - b v becomes the sixth row of its hinge, which ODE states as
// v = vel - cfm * t with t unbounded: vel = t0 / b, cfm = 1 / b.  ODE finds t together with
// all other forces, at the speed v of the end of the step.  It is a torque that gives way,
// not a prescribed speed, which would be cfm = 0.
void OdeBody::Impl::Step(double step_s) {
  for (size_t j = 0; j < servos_.size(); ++j) {
    const TorqueLine line =
        servos_[j].Step(state.joints[j].angle_rad, state.joints[j].speed_rad_s, step_s);
    dJointSetHingeParam(hinges_[j], dParamVel, line.zero_speed_nm / line.slope_nm_s);
    dJointSetHingeParam(hinges_[j], dParamCFM, 1 / line.slope_nm_s);
  }
  finder_->Find(&points_);
  solver_->Step(points_, [this, step_s] { SolveStep(step_s); });
  for (const ContactPoint& point : points_) {
    if (point.paw >= 0) state.paws[point.paw] = true;
  }
  ReadState();
}

void OdeBody::Impl::SolveStep(double step_s) {
  for (const PushForce& push : pushes) {
    dBodyAddForceAtPos(bodies_[push.body], push.force_W.x(), push.force_W.y(), push.force_W.z(),
                       push.p_W.x(), push.p_W.y(), push.p_W.z());
  }
  const OdeRandomScope random(&random_seed_);
  ClearUpperRegisters();  // because libode is SSE code, at a third of the speed otherwise
  if (settings_.solver == OdeSettings::Solver::kExact) {
    dWorldStep(world_, step_s);
  } else {
    dWorldQuickStep(world_, step_s);
  }
}

void OdeBody::Impl::ReadState() {
  for (size_t j = 0; j < servos_.size(); ++j) {
    const JointModel& joint = model_.joints[j];
    const dBodyID parent = bodies_[joint.parent], child = bodies_[joint.child];
    state.joints[j].angle_rad = MeasureAngle(axes_[j], parent, child);
    state.joints[j].speed_rad_s = MeasureSpeed(axes_[j], parent, child);
  }
  const Matrix3d R = RotationOf(bodies_[0]);
  const Vector3d centre_W = R * model_.bodies[0].centre_m;  // from B's origin
  state.X_WB.linear() = R;
  state.X_WB.translation() = ToEigen(dBodyGetPosition(bodies_[0])) - centre_W;
  state.w_WB = ToEigen(dBodyGetAngularVel(bodies_[0]));
  state.v_WB = ToEigen(dBodyGetLinearVel(bodies_[0])) - state.w_WB.cross(centre_W);
}

Isometry3d OdeBody::Impl::PoseOf(int body) const {
  Isometry3d X_WL;
  X_WL.linear() = RotationOf(bodies_[body]);
  X_WL.translation() =
      ToEigen(dBodyGetPosition(bodies_[body])) - X_WL.linear() * model_.bodies[body].centre_m;
  X_WL.makeAffine();
  return X_WL;
}

double OdeBody::Impl::HingeError() const {
  double error_m = 0;
  for (const dJointID hinge : hinges_) {
    dVector3 end1, end2;
    dJointGetHingeAnchor(hinge, end1);
    dJointGetHingeAnchor2(hinge, end2);
    error_m = std::max(error_m, (ToEigen(end1) - ToEigen(end2)).norm());
  }
  return error_m;
}

void OdeBody::Impl::HashState(Hasher* hasher) const {
  HashWorld(world, hasher);
  std::vector<double> values;
  values.reserve(13 * bodies_.size() + 3);
  for (const dBodyID body : bodies_) {
    values.insert(values.end(), dBodyGetPosition(body), dBodyGetPosition(body) + 3);
    values.insert(values.end(), dBodyGetQuaternion(body), dBodyGetQuaternion(body) + 4);
    values.insert(values.end(), dBodyGetLinearVel(body), dBodyGetLinearVel(body) + 3);
    values.insert(values.end(), dBodyGetAngularVel(body), dBodyGetAngularVel(body) + 3);
  }
  values.insert(values.end(), state.gravity_B.data(), state.gravity_B.data() + 3);
  hasher->AddBytes(values.data(), values.size() * sizeof(double));
  for (const bool touches : state.paws) hasher->Add(touches);
  for (const Servo& servo : servos_) servo.HashState(hasher);
  solver_->HashState(hasher);
  hasher->Add(random_seed_);
  for (const PushForce& push : pushes) {
    hasher->Add(push.body);
    hasher->AddBytes(push.force_W.data(), 3 * sizeof(double));
    hasher->AddBytes(push.p_W.data(), 3 * sizeof(double));
  }
}

OdeBody::OdeBody(const RobotModel& model, const World& world, const OdeSettings& settings)
    : impl_(std::make_unique<Impl>(model, world, settings)) {}

OdeBody::~OdeBody() = default;

void OdeBody::Advance(const std::vector<JointCommand>& commands) { impl_->Advance(commands); }

const BodyState& OdeBody::state() const { return impl_->state; }

double OdeBody::RayDistance(const Vector3d& p_W, const Vector3d& direction_W, double max_m) const {
  return openr_host::RayDistance(impl_->world, p_W, direction_W, max_m);
}

std::vector<Isometry3d> OdeBody::BodyPoses() const {
  std::vector<Isometry3d> X_WL;
  for (size_t i = 0; i < impl_->bodies().size(); ++i) {
    X_WL.push_back(impl_->PoseOf(static_cast<int>(i)));
  }
  return X_WL;
}

void OdeBody::HashState(Hasher* hasher) const { impl_->HashState(hasher); }

void OdeBody::Push(int body, const Vector3d& force_W, const Vector3d& p_W) {
  impl_->pushes.push_back({body, force_W, p_W});
}

double OdeBody::HingeError() const { return impl_->HingeError(); }

std::unique_ptr<Body> MakeOdeBody(const RobotModel& model, const World& world) {
  return std::make_unique<OdeBody>(model, world);
}

}  // namespace openr_host
