#include "virtualrobot/ode/ode_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "virtualrobot/body/kinematics.h"
#include "virtualrobot/body/robot_things.h"
#include "virtualrobot/ode/ode_bodies.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Parameters of a person's hand that holds the trunk (our choices): the time in which the hand
// moves the trunk to the wanted pose, and the limits of the hand's speed, force and torque.
constexpr double kHandTime_s = 0.05;
constexpr double kHandSpeed_m_s = 0.5, kHandTurn_rad_s = 2;
constexpr double kHandForce_n = 60, kHandTorque_nm = 5;

// The largest distance, in m, of a part of a robot from the origin of the robot's base.  A ray that
// stays further away misses the robot.
constexpr double kReach_m = 0.6;

// Returns the pose in which a robot lies at `start` in the sleeping posture.
RestingPose StartPose(const RobotModel& model, const StartPlace& start) {
  RestingPose pose = PlaceOnFloor(model, model.PostureAngles("sleep"));
  pose.X_WB = MovedTo(start, pose.X_WB);
  return pose;
}

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
    : OdeBody(model, world, PlaceOnFloor(model, model.PostureAngles("sleep")),
              model.PostureAngles("sleep"), settings) {}

OdeBody::OdeBody(const RobotModel& model, const World& world, const RestingPose& pose,
                 const std::vector<double>& angles_rad, const OdeSettings& settings)
    : OdeBody(model, std::make_shared<PhysicsWorld>(world, settings), pose, angles_rad) {}

OdeBody::OdeBody(const RobotModel& model, std::shared_ptr<PhysicsWorld> world,
                 const StartPlace& start)
    : OdeBody(model, std::move(world), StartPose(model, start), model.PostureAngles("sleep")) {}

OdeBody::OdeBody(const RobotModel& model, std::shared_ptr<PhysicsWorld> world,
                 const RestingPose& pose, const std::vector<double>& angles_rad)
    : model_(model), world_(std::move(world)) {
  RefuseUnlessPhysical(model);
  for (const BodyPart& part : model.bodies) bodies_.push_back(MakeBody(world_->ode(), part));
  MakeTree(pose, angles_rad);
  for (const JointModel& joint : model.joints)
    servos_.emplace_back(joint, world_->settings().servo);
  lines_.resize(bodies_.size());
  PlaceBodies();
  state_.joints.resize(model.joints.size());
  ReadState();
  state_.paws = pose.paws;
  state_.gravity_B = state_.X_WB.linear().transpose() * Vector3d(0, 0, -kGravity_m_s2);
  world_->AddRobot(this);
}

void OdeBody::MakeTree(const RestingPose& pose, const std::vector<double>& angles_rad) {
  std::vector<TreePart> parts;
  std::vector<double> part_angles_rad;
  for (size_t i = 0; i < bodies_.size(); ++i) {
    const BodyPart& part = model_.bodies[i];
    parts.push_back({.mass_kg = MassOf(bodies_[i]),
                     .inertia_kg_m2 = InertiaOf(bodies_[i]),
                     .centre_m = part.centre_m});
    part_angles_rad.push_back(0);
    if (part.joint < 0) continue;
    const JointModel& joint = model_.joints[part.joint];
    parts[i].parent = joint.parent;
    parts[i].axis = joint.axis;
    parts[i].anchor_m = joint.anchor_m;
    part_angles_rad[i] = angles_rad[part.joint];
  }
  tree_ = std::make_unique<JointTree>(parts);
  tree_->Place(pose.X_WB, part_angles_rad);
}

void OdeBody::SetCommands(const std::vector<JointCommand>& commands) {
  ASSERT(commands.size() == servos_.size(), "{} commands for {} joints", commands.size(),
         servos_.size());
  for (size_t j = 0; j < servos_.size(); ++j) {
    servos_[j].BeginFrame(commands[j], state_.joints[j].angle_rad);
  }
  world_->AwaitFrame();
}

void OdeBody::BeginFrame() {
  v_before_W_ = state_.v_WB;
  state_.paws.assign(model_.paws.size(), false);
  state_.paw_forces_n.assign(model_.paws.size(), 0);
}

void OdeBody::BeginStep(double step_s) {
  for (size_t j = 0; j < servos_.size(); ++j) {
    lines_[model_.joints[j].child] =
        servos_[j].Step(state_.joints[j].angle_rad, state_.joints[j].speed_rad_s, step_s);
  }
  tree_->BeginStep(lines_, kGravity_m_s2, step_s);
  for (const PushForce& push : pushes_) tree_->AddForce(push.part, push.force_W, push.p_W);
  if (held_at_) PullByHand(step_s);
}

void OdeBody::EndStep() {
  PlaceBodies();
  ReadState();
}

void OdeBody::EndFrame() {
  pushes_.clear();
  for (size_t j = 0; j < servos_.size(); ++j) {
    JointState& joint = state_.joints[j];
    joint.drive = servos_[j].Drive(joint.angle_rad, joint.speed_rad_s);
  }
  // Computes the mean acceleration over the frame, because the accelerometer's value is a mean over
  // the frame, too.
  const Vector3d acceleration_W = (state_.v_WB - v_before_W_) / kFrame_s;
  state_.gravity_B =
      state_.X_WB.linear().transpose() * (Vector3d(0, 0, -kGravity_m_s2) - acceleration_W);
}

// Moves ODE's bodies to the places of the tree's parts, because collisions are found with ODE's
// bodies.
void OdeBody::PlaceBodies() {
  for (int i = 0; i < tree_->parts(); ++i)
    PlaceBody(bodies_[i], tree_->centre_W(i), tree_->R_WL(i));
}

void OdeBody::ReadState() {
  for (size_t j = 0; j < servos_.size(); ++j) {
    state_.joints[j].angle_rad = tree_->angle_rad(model_.joints[j].child);
    state_.joints[j].speed_rad_s = tree_->speed_rad_s(model_.joints[j].child);
  }
  state_.X_WB = tree_->X_WL(0);
  state_.w_WB = tree_->w_W();
  state_.v_WB = tree_->v_W() - state_.w_WB.cross(tree_->R_WL(0) * model_.bodies[0].centre_m);
}

std::vector<Isometry3d> OdeBody::BodyPoses() const {
  std::vector<Isometry3d> X_WL;
  for (int i = 0; i < tree_->parts(); ++i) X_WL.push_back(tree_->X_WL(i));
  return X_WL;
}

RayHit OdeBody::CastRay(const Vector3d& p_W, const Vector3d& direction_W, double max_m) const {
  RayHit hit = openr_host::CastRay(world(), world_->things(), p_W, direction_W, max_m);
  for (const OdeBody* const robot : world_->robots()) {
    if (robot == this) continue;
    // First tests a ball around the robot, because most robots are not in the way of the ray.
    const Vector3d to_robot = robot->state_.X_WB.translation() - p_W;
    const double along_m = std::clamp(to_robot.dot(direction_W), 0.0, hit.distance_m);
    if ((to_robot - along_m * direction_W).norm() > kReach_m) continue;
    CastRayOnThings(
        ThingsOfRobot(robot->model_, robot->BodyPoses(), std::vector<bool>(robot->bodies_.size())),
        p_W, direction_W, &hit);
  }
  return hit;
}

std::vector<WorldThing> OdeBody::Surroundings() const {
  std::vector<WorldThing> things = world_->things();
  for (const OdeBody* const robot : world_->robots()) {
    if (robot == this) continue;
    const std::vector<bool> none_left_out(robot->bodies_.size());
    for (WorldThing& thing : ThingsOfRobot(robot->model_, robot->BodyPoses(), none_left_out))
      things.push_back(std::move(thing));
  }
  return things;
}

std::vector<WorldThing> OdeBody::MovableThings() const {
  std::vector<WorldThing> things;
  for (const WorldThing& thing : world_->things()) {
    if (thing.mass_kg > 0) things.push_back(thing);
  }
  return things;
}

bool OdeBody::PutThing(size_t thing, const Vector3d& centre_m) {
  if (thing >= world().things.size() || world().things[thing].mass_kg == 0) return false;
  world_->PutThing(thing, centre_m);
  return true;
}

void OdeBody::HashState(Hasher* hasher) const {
  HashWorld(world(), hasher);
  world_->HashThings(hasher);
  tree_->HashState(hasher);
  hasher->AddBytes(state_.gravity_B.data(), 3 * sizeof(double));
  for (const bool touches : state_.paws) hasher->Add(touches);
  for (const Servo& servo : servos_) servo.HashState(hasher);
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

// Adds the force and the torque of a person's hand that holds the trunk.  The hand carries the
// weight of the robot at its centre of mass.  It also moves the trunk towards held_at_: the wanted
// speed is the distance divided by kHandTime_s, up to a limit.  The force is half of the force that
// would give the trunk alone the wanted speed in one step.  So the trunk, with the legs and the
// head that hang on it, reaches this speed only after some steps.
void OdeBody::PullByHand(double step_s) {
  const double mass_kg = model_.TotalMassKg();
  Vector3d centre_W = Vector3d::Zero();
  for (size_t i = 0; i < bodies_.size(); ++i)
    centre_W += tree_->centre_W(static_cast<int>(i)) * (model_.bodies[i].mass_kg / mass_kg);
  tree_->AddForce(0, Vector3d(0, 0, mass_kg * kGravity_m_s2), centre_W);

  const Vector3d v_wanted_W =
      Limited((held_at_->translation() - state_.X_WB.translation()) / kHandTime_s, kHandSpeed_m_s);
  const Vector3d force_W =
      Limited((v_wanted_W - state_.v_WB) * (0.5 * model_.bodies[0].mass_kg / step_s), kHandForce_n);
  tree_->AddForce(0, force_W, tree_->centre_W(0));

  // Computes the rotation from the present orientation of the trunk to the orientation that the
  // person's hand wants, as a vector: the axis of the rotation times its angle.  For a small
  // rotation, this vector is half the sum of three cross products: of each present axis of the
  // trunk with the same axis in the wanted orientation.
  const Matrix3d R = state_.X_WB.linear();
  Vector3d turn_W = Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis)
    turn_W += 0.5 * R.col(axis).cross(held_at_->linear().col(axis));
  const Vector3d w_wanted_W = Limited(turn_W / kHandTime_s, kHandTurn_rad_s);
  const Matrix3d inertia_B = InertiaOf(bodies_[0]);
  const Vector3d torque_W =
      Limited(R * (inertia_B * (R.transpose() * (w_wanted_W - state_.w_WB))) * (0.5 / step_s),
              kHandTorque_nm);
  tree_->AddTorque(0, torque_W);
}

std::unique_ptr<Body> MakeOdeBody(const RobotModel& model, const World& world,
                                  const StartPlace& start) {
  return MakeOdeBody(model, MakePhysicsWorld(world), start);
}

std::shared_ptr<PhysicsWorld> MakePhysicsWorld(const World& world) {
  return std::make_shared<PhysicsWorld>(world);
}

std::unique_ptr<Body> MakeOdeBody(const RobotModel& model, std::shared_ptr<PhysicsWorld> world,
                                  const StartPlace& start) {
  return std::make_unique<OdeBody>(model, std::move(world), start);
}

}  // namespace openr_host
