// Moves a body by set points, one command per frame: holds, and ramps between postures.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "runtime/base/hasher.h"
#include "virtualrobot/body.h"
#include "virtualrobot/det_math.h"
#include "virtualrobot/kinematics.h"

namespace openr_host {

// The robots' data; the build says where they are.
inline RobotModel ModelNamed(const std::string& file) {
  return LoadRobotModel(std::string(OPENR_MODEL_DIR) + "/" + file);
}

inline const RobotModel& Ers210() {
  static const RobotModel model = ModelNamed("ers210.json");
  return model;
}

inline int FramesIn(double seconds) { return static_cast<int>(std::lround(seconds / kFrame_s)); }

class BodyHarness {
 public:
  // Both must outlive the harness.
  BodyHarness(const RobotModel& model, Body* body) : model_(model), body_(*body) {
    for (const JointModel& joint : model.joints) {
      commands.push_back({.target_rad = 0, .enabled = false, .gains = joint.gains});
    }
  }

  void Frame() { body_.Advance(commands); }
  void Hold(double seconds) {
    for (int i = FramesIn(seconds); i > 0; --i) Frame();
  }

  // Switches the gains on at the present position, as a careful program does.
  void EnableAll() {
    for (size_t j = 0; j < commands.size(); ++j) {
      commands[j].target_rad = body_.state().joints[j].angle_rad;
      commands[j].enabled = true;
    }
  }

  // All joints start and arrive together; the slowest moves at 0.9 of its planned speed limit.
  void RampTo(const std::vector<double>& to_rad) {
    double seconds = kFrame_s;
    std::vector<double> from_rad;
    for (size_t j = 0; j < commands.size(); ++j) {
      from_rad.push_back(commands[j].target_rad);
      seconds = std::max(
          seconds, std::fabs(to_rad[j] - from_rad[j]) / (0.9 * model_.joints[j].speed_rad_s.max));
    }
    const int frames = static_cast<int>(seconds / kFrame_s) + 1;
    for (int i = 1; i <= frames; ++i) {
      for (size_t j = 0; j < commands.size(); ++j) {
        commands[j].target_rad = from_rad[j] + (to_rad[j] - from_rad[j]) * i / frames;
      }
      Frame();
    }
  }

  // A posture of the model, kept to the software limits.
  std::vector<double> Posture(const std::string& name) const {
    std::vector<double> angles_rad = model_.PostureAngles(name);
    for (size_t j = 0; j < angles_rad.size(); ++j) {
      const Range& soft = model_.joints[j].soft_rad;
      angles_rad[j] = std::clamp(angles_rad[j], soft.min, soft.max);
    }
    return angles_rad;
  }

  void StandUp() {
    EnableAll();
    for (const char* name : {"broadbase", "sleep", "crouch", "stand"}) {
      RampTo(Posture(name));
      Hold(0.3);
    }
    Hold(2);
  }

  Eigen::Vector3d RpyDegrees() const {
    const Eigen::Vector3d rpy_rad = RpyOf(body_.state().X_WB.linear());
    return {Degrees(rpy_rad.x()), Degrees(rpy_rad.y()), Degrees(rpy_rad.z())};
  }
  Eigen::Vector3d Position_mm() const { return body_.state().X_WB.translation() * 1000; }

  // Largest distance of a joint from its set point, in degrees.
  double JointErrorDegrees() const {
    double error = 0;
    for (size_t j = 0; j < commands.size(); ++j) {
      error = std::max(
          error, std::fabs(Degrees(commands[j].target_rad - body_.state().joints[j].angle_rad)));
    }
    return error;
  }

  int PawsDown() const {
    return static_cast<int>(std::count(body_.state().paws.begin(), body_.state().paws.end(), true));
  }

  double AngleDegrees(const std::string& joint) const {
    return Degrees(body_.state().joints[model_.FindJoint(joint)].angle_rad);
  }
  JointCommand& Command(const std::string& joint) { return commands[model_.FindJoint(joint)]; }

  std::vector<JointCommand> commands;

 private:
  const RobotModel& model_;
  Body& body_;
};

inline uint64_t StateHash(const Body& body) {
  Hasher hasher;
  body.HashState(&hasher);
  return hasher.Digest();
}

// The text of the exception that a piece of code throws.  The test fails when it throws none.
template <typename Code>
std::string ErrorOf(Code code) {
  try {
    code();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

}  // namespace openr_host
