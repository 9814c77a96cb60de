// A dog of examples/BallChaser on the body with physics: its motion, without objects and messages.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "Motion.h"
#include "tests/virtualrobot/body_harness.h"

namespace openr_host {

class WalkingDog {
 public:
  explicit WalkingDog(const World& world = {}) : body_(MakeOdeBody(Ers210(), world)) {
    for (size_t j = 0; j < indices_.size(); ++j) {
      const JointModel* const joint = FindByLocator(JOINTS[j].locator);
      indices_[j] = static_cast<size_t>(joint - Ers210().joints.data());
    }
    std::array<double, NUM_JOINTS> now{};
    for (const JointModel& joint : Ers210().joints) {
      const JointState& state = body_->state().joints[commands_.size()];
      commands_.push_back({.target_rad = state.angle_rad, .enabled = true, .gains = joint.gains});
    }
    for (size_t j = 0; j < indices_.size(); ++j)
      now[j] = body_->state().joints[indices_[j]].angle_rad;
    motion_.Begin(now.data());
    Run(2);
  }

  void Walk(double forward, double left, double turn_deg_s) {
    motion_.SetCommand({forward, left, Radians(turn_deg_s), 0, 0});
  }

  // Lets the dog feel and move for `seconds`, as Walker does: sensors every four frames.
  void Run(double seconds) {
    std::array<double, NUM_JOINTS> angles{};
    for (int i = FramesIn(seconds); i > 0; --i) {
      const Eigen::Vector3d& gravity = body_->state().gravity_B;
      if (i % 4 == 0) motion_.Feel(gravity.x(), -gravity.y(), gravity.z());
      motion_.Step(angles.data());
      for (size_t j = 0; j < indices_.size(); ++j) commands_[indices_[j]].target_rad = angles[j];
      const Eigen::Vector3d before = p_mm();
      const double yaw_before = yaw_rad_;
      body_->Advance(commands_);
      FollowYaw();
      const double yaw_rad = (yaw_before + yaw_rad_) / 2;
      const Eigen::Vector3d way = p_mm() - before;
      forward_mm_ += way.x() * std::cos(yaw_rad) + way.y() * std::sin(yaw_rad);
      left_mm_ += way.y() * std::cos(yaw_rad) - way.x() * std::sin(yaw_rad);
      tilt_deg_max_ = std::max(tilt_deg_max_, TiltDegrees());
    }
  }

  // Forgets the way so far.
  void Count() {
    forward_mm_ = left_mm_ = tilt_deg_max_ = 0;
    yaw_begin_rad_ = yaw_rad_;
  }
  double forward_mm() const { return forward_mm_; }
  double left_mm() const { return left_mm_; }
  double turn_deg() const { return Degrees(yaw_rad_ - yaw_begin_rad_); }
  double tilt_deg_max() const { return tilt_deg_max_; }

  // The angle between the dog's own up and that of the world.
  double TiltDegrees() const { return Degrees(std::acos(body_->state().X_WB.linear()(2, 2))); }

  Body& body() { return *body_; }
  Motion& motion() { return motion_; }

 private:
  static const JointModel* FindByLocator(const std::string& locator) {
    const auto& joints = Ers210().joints;
    const auto found = std::find_if(joints.begin(), joints.end(),
                                    [&](const auto& joint) { return joint.locator == locator; });
    EXPECT_NE(found, joints.end()) << locator;
    return &*found;
  }

  Eigen::Vector3d p_mm() const { return body_->state().X_WB.translation() * 1000; }

  void FollowYaw() {
    const double now_rad = RpyOf(body_->state().X_WB.linear()).z();
    yaw_rad_ += std::remainder(now_rad - yaw_rad_, 2 * kPi);
  }

  std::unique_ptr<Body> body_;
  Motion motion_;
  std::vector<JointCommand> commands_;
  std::array<size_t, NUM_JOINTS> indices_{};
  double yaw_rad_ = 0, yaw_begin_rad_ = 0;
  double forward_mm_ = 0, left_mm_ = 0, tilt_deg_max_ = 0;
};

}  // namespace openr_host
