#include "virtualrobot/body/ideal_body.h"

#include <algorithm>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// Returns the angle that a joint has at the end of a frame in which `disturbance`, a fault or a
// person's hand, acts on the joint.  At the beginning of the frame, the joint is at `angle_rad`.
// Without the disturbance, the servo would move the joint to `goal_rad`.
double DisturbedAngle(const JointDisturbance& disturbance, double angle_rad, double goal_rad) {
  if (disturbance.jammed_rad || (disturbance.strength == 0 && !disturbance.hand_rad))
    return angle_rad;
  return disturbance.hand_rad.value_or(goal_rad);
}

}  // namespace

IdealBody::IdealBody(const RobotModel& model, const World& world, const StartPlace& start)
    : model_(model), world_(world), start_(start), robot_(model) {
  for (const double angle_rad : model.PostureAngles("sleep")) {
    state_.joints.push_back({.angle_rad = angle_rad, .speed_rad_s = 0, .drive = 0});
  }
}

void IdealBody::SetCommands(const std::vector<JointCommand>& commands) {
  ASSERT(commands.size() == state_.joints.size(), "{} commands for {} joints", commands.size(),
         state_.joints.size());
  for (size_t j = 0; j < commands.size(); ++j) {
    JointState& joint = state_.joints[j];
    double angle_rad = joint.angle_rad;
    if (commands[j].enabled) {
      const Range& stops_rad = model_.joints[j].hard_rad;
      angle_rad = std::clamp(commands[j].target_rad, stops_rad.min, stops_rad.max);
    }
    if (commands[j].disturbance != nullptr)
      angle_rad = DisturbedAngle(*commands[j].disturbance, joint.angle_rad, angle_rad);
    joint.speed_rad_s = (angle_rad - joint.angle_rad) / kFrame_s;
    if (angle_rad != joint.angle_rad) placed_ = false;
    joint.angle_rad = angle_rad;
  }
}

// Computes the pose of the robot's base, which paws touch the floor, and what the accelerometer
// measures.
void IdealBody::Place() const {
  for (size_t j = 0; j < state_.joints.size(); ++j) robot_.SetAngle(j, state_.joints[j].angle_rad);
  robot_.Move();
  if (held_at_) {
    PlaceInHand();
  } else {
    robot_.PlaceOnFloor(&pose_);
    pose_.X_WB = MovedTo(start_, pose_.X_WB);
  }
  state_.X_WB = pose_.X_WB;
  state_.paws = pose_.paws;
  state_.gravity_B = pose_.X_WB.linear().transpose() * Vector3d(0, 0, -kGravity_m_s2);
  placed_ = true;
}

// Puts the robot into the pose that the hand of a person gives it.  No paw then touches the floor.
void IdealBody::PlaceInHand() const {
  pose_.X_WB = *held_at_;
  pose_.paws.assign(model_.paws.size(), false);
  const double lowest_m = robot_.LowestPoint(pose_.X_WB);
  if (lowest_m < 0) pose_.X_WB.translation().z() -= lowest_m;
}

void IdealBody::Hold(const std::optional<Isometry3d>& X_WB) {
  held_at_ = X_WB;
  placed_ = false;
}

const BodyState& IdealBody::state() const {
  if (!placed_) Place();
  return state_;
}

RayHit IdealBody::CastRay(const Vector3d& p_W, const Vector3d& direction_W, double max_m) const {
  return openr_host::CastRay(world_, world_.things, p_W, direction_W, max_m);
}

std::vector<Isometry3d> IdealBody::BodyPoses() const {
  std::vector<Isometry3d> X_WL;
  X_WL.reserve(model_.bodies.size());
  for (size_t i = 0; i < model_.bodies.size(); ++i) X_WL.push_back(PoseOf(i));
  return X_WL;
}

Isometry3d IdealBody::PoseOf(size_t part) const {
  if (!placed_) Place();
  return pose_.X_WB * robot_.X_BL()[part];
}

void IdealBody::HashState(Hasher* hasher) const {
  HashWorld(world_, hasher);
  for (const double place : {start_.x_m, start_.y_m, start_.yaw_rad}) {
    if (place != 0) hasher->Add(place);
  }
  // Hashes only the joints, because poses and paws follow from the angles of the joints.
  for (const JointState& joint : state_.joints) {
    hasher->Add(joint.angle_rad);
    hasher->Add(joint.speed_rad_s);
  }
  if (held_at_) hasher->AddBytes(held_at_->data(), 16 * sizeof(double));
}

std::unique_ptr<Body> MakeIdealBody(const RobotModel& model, const World& world,
                                    const StartPlace& start) {
  return std::make_unique<IdealBody>(model, world, start);
}

}  // namespace openr_host
