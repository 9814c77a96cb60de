// A body without physics or geometry: joints are where their commands say.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "runtime/base/hasher.h"
#include "virtualrobot/body/body.h"

namespace openr_host {

class FollowBody : public Body {
 public:
  explicit FollowBody(const RobotModel& model, World world = {})
      : world_(std::move(world)), poses_(model.bodies.size(), Eigen::Isometry3d::Identity()) {
    state_.joints.resize(model.joints.size());
    state_.paws.resize(model.paws.size());
  }
  using Body::Advance;
  void Advance() override {}
  void SetCommands(const std::vector<JointCommand>& commands) override {
    ++frames;
    last_commands = commands;
    for (size_t i = 0; i < commands.size(); ++i) {
      if (commands[i].enabled) state_.joints[i].angle_rad = commands[i].target_rad;
    }
  }
  const BodyState& state() const override { return state_; }
  RayHit CastRay(const Eigen::Vector3d&, const Eigen::Vector3d&, double max_m) const override {
    return {.distance_m = distance_m < max_m ? distance_m : max_m, .reflectance = reflectance};
  }
  const World& world() const override { return world_; }
  std::vector<Eigen::Isometry3d> BodyPoses() const override { return poses_; }
  void HashState(Hasher* hasher) const override {
    for (const JointState& joint : state_.joints) hasher->Add(joint.angle_rad);
  }

  BodyState& mutable_state() { return state_; }
  // Puts the stiff robot, with all joints at 0, to `X_WB`.
  void Place(const Eigen::Isometry3d& X_WB) { std::fill(poses_.begin(), poses_.end(), X_WB); }

  int frames = 0;
  double distance_m = 10, reflectance = 1;
  std::vector<JointCommand> last_commands;

 private:
  const World world_;
  BodyState state_;
  std::vector<Eigen::Isometry3d> poses_;
};

}  // namespace openr_host
