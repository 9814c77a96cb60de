#include "virtualrobot/body/body_mover.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/assert.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host {

int FramesIn(double seconds) { return static_cast<int>(std::lround(seconds / kFrame_s)); }

BodyMover::BodyMover(const RobotModel& model, Body* body) : model_(model), body_(*body) {
  for (const JointModel& joint : model.joints)
    commands.push_back({.target_rad = 0, .enabled = false, .gains = joint.gains});
}

void BodyMover::Hold(double seconds) {
  for (int i = FramesIn(seconds); i > 0; --i) Frame();
}

void BodyMover::EnableAll() {
  for (size_t j = 0; j < commands.size(); ++j) {
    // Begins with the angle that the joint has now, so that no joint jerks when its servo is
    // switched on.
    commands[j].target_rad = body_.state().joints[j].angle_rad;
    commands[j].enabled = true;
  }
}

void BodyMover::RampTo(const std::vector<double>& to_rad) {
  ASSERT(to_rad.size() == commands.size(), "{} angles for {} joints", to_rad.size(),
         commands.size());
  double seconds = kFrame_s;
  std::vector<double> from_rad;
  for (size_t j = 0; j < commands.size(); ++j) {
    from_rad.push_back(commands[j].target_rad);
    seconds = std::max(
        seconds, std::fabs(to_rad[j] - from_rad[j]) / (0.9 * model_.joints[j].speed_rad_s.max));
  }
  const int frames = static_cast<int>(seconds / kFrame_s) + 1;
  for (int i = 1; i <= frames; ++i) {
    for (size_t j = 0; j < commands.size(); ++j)
      commands[j].target_rad = from_rad[j] + (to_rad[j] - from_rad[j]) * i / frames;
    Frame();
  }
}

std::vector<double> BodyMover::Posture(const std::string& name) const {
  std::vector<double> angles_rad = model_.PostureAngles(name);
  for (size_t j = 0; j < angles_rad.size(); ++j) {
    const Range& soft = model_.joints[j].soft_rad;
    angles_rad[j] = std::clamp(angles_rad[j], soft.min, soft.max);
  }
  return angles_rad;
}

void BodyMover::StandUp() {
  EnableAll();
  // Uses the postures with which the object JointMover begins (objects/JointMover/MoverCore.cc), so
  // that the body stands up as it does under this object.
  for (const char* const name : {"broadbase", "sleep", "crouch", "stand"}) {
    const bool is_known = std::any_of(model_.postures.begin(), model_.postures.end(),
                                      [name](const auto& posture) { return posture.name == name; });
    if (!is_known) continue;
    RampTo(Posture(name));
    Hold(0.3);
  }
  Hold(2);
}

double BodyMover::JointErrorDegrees() const {
  double error_deg = 0;
  for (size_t j = 0; j < commands.size(); ++j) {
    const double error_rad = commands[j].target_rad - body_.state().joints[j].angle_rad;
    error_deg = std::max(error_deg, std::fabs(Degrees(error_rad)));
  }
  return error_deg;
}

}  // namespace openr_host
