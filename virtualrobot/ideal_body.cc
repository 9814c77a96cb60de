#include "virtualrobot/ideal_body.h"

#include <algorithm>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

}  // namespace

IdealBody::IdealBody(const RobotModel& model, const World& world) : model_(model), world_(world) {
  for (const double angle_rad : model.PostureAngles("sleep")) {
    state_.joints.push_back({.angle_rad = angle_rad, .speed_rad_s = 0, .drive = 0});
  }
}

void IdealBody::Advance(const std::vector<JointCommand>& commands) {
  ASSERT(commands.size() == state_.joints.size(), "{} commands for {} joints", commands.size(),
         state_.joints.size());
  for (size_t j = 0; j < commands.size(); ++j) {
    JointState& joint = state_.joints[j];
    double angle_rad = joint.angle_rad;
    if (commands[j].enabled) {
      const Range& stops_rad = model_.joints[j].hard_rad;
      angle_rad = std::clamp(commands[j].target_rad, stops_rad.min, stops_rad.max);
    }
    joint.speed_rad_s = (angle_rad - joint.angle_rad) / kFrame_s;
    if (angle_rad != joint.angle_rad) placed_ = false;
    joint.angle_rad = angle_rad;
  }
}

void IdealBody::Place() const {
  X_WL_ = LinkPoses(model_, Angles());
  const RestingPose pose = held_at_ ? HeldPose() : PlaceOnFloor(model_, X_WL_);
  state_.X_WB = pose.X_WB;
  state_.paws = pose.paws;
  state_.gravity_B = pose.X_WB.linear().transpose() * Vector3d(0, 0, -kGravity_m_s2);
  for (Isometry3d& X : X_WL_) X = pose.X_WB * X;
  placed_ = true;
}

// Returns the pose of a robot that a hand holds.  Its paws touch nothing.
RestingPose IdealBody::HeldPose() const {
  RestingPose pose;
  pose.X_WB = *held_at_;
  pose.paws.assign(model_.paws.size(), false);
  const double lowest_m = LowestPoint(model_, Angles(), pose.X_WB);
  if (lowest_m < 0) pose.X_WB.translation().z() -= lowest_m;
  return pose;
}

void IdealBody::Hold(const std::optional<Isometry3d>& X_WB) {
  held_at_ = X_WB;
  placed_ = false;
}

const BodyState& IdealBody::state() const {
  if (!placed_) Place();
  return state_;
}

double IdealBody::RayDistance(const Vector3d& p_W, const Vector3d& direction_W,
                              double max_m) const {
  return openr_host::RayDistance(world_, p_W, direction_W, max_m);
}

std::vector<Isometry3d> IdealBody::BodyPoses() const {
  if (!placed_) Place();
  return X_WL_;
}

void IdealBody::HashState(Hasher* hasher) const {
  HashWorld(world_, hasher);
  for (const JointState& joint : state_.joints) {  // everything else follows from the angles
    hasher->Add(joint.angle_rad);
    hasher->Add(joint.speed_rad_s);
  }
  if (held_at_) hasher->AddBytes(held_at_->data(), 16 * sizeof(double));
}

std::vector<double> IdealBody::Angles() const {
  std::vector<double> angles_rad;
  angles_rad.reserve(state_.joints.size());
  for (const JointState& joint : state_.joints) angles_rad.push_back(joint.angle_rad);
  return angles_rad;
}

std::unique_ptr<Body> MakeIdealBody(const RobotModel& model, const World& world) {
  return std::make_unique<IdealBody>(model, world);
}

}  // namespace openr_host
