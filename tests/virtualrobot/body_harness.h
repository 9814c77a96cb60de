// A body under test: moves it by set points (virtualrobot/body/body_mover.h) and looks at it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "runtime/base/hasher.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/rotation.h"
#include "virtualrobot/body/body.h"
#include "virtualrobot/body/body_mover.h"
#include "virtualrobot/body/kinematics.h"

namespace openr_host {

// The robots' data; the build says where they are.
inline RobotModel ModelNamed(const std::string& file) {
  return LoadRobotModel(std::string(OPENR_MODEL_DIR) + "/" + file);
}

inline const RobotModel& Ers210() {
  static const RobotModel model = ModelNamed("ers210.json");
  return model;
}

class BodyHarness : public BodyMover {
 public:
  // Both must outlive the harness.
  BodyHarness(const RobotModel& model, Body* body)
      : BodyMover(model, body), model_(model), body_(*body) {}

  Eigen::Vector3d RpyDegrees() const {
    const Eigen::Vector3d rpy_rad = RpyOf(body_.state().X_WB.linear());
    return {Degrees(rpy_rad.x()), Degrees(rpy_rad.y()), Degrees(rpy_rad.z())};
  }
  Eigen::Vector3d Position_mm() const { return body_.state().X_WB.translation() * 1000; }

  int PawsDown() const {
    return static_cast<int>(std::count(body_.state().paws.begin(), body_.state().paws.end(), true));
  }

  double AngleDegrees(const std::string& joint) const {
    return Degrees(body_.state().joints[model_.FindJoint(joint)].angle_rad);
  }
  JointCommand& Command(const std::string& joint) { return commands[model_.FindJoint(joint)]; }

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
