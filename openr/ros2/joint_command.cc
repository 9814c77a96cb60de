#include "openr/ros2/joint_command.h"

#include <fmt/format.h>

#include <cmath>

namespace openr_host {
namespace {

// Returns `text` shortened and without control characters.  The text comes from the network and
// could otherwise fill or damage the user's terminal.
std::string Shown(const std::string& text) {
  constexpr size_t kMax = 40;
  std::string shown;
  for (const char c : text.substr(0, kMax)) shown += c >= ' ' && c <= '~' ? c : '?';
  return text.size() > kMax ? shown + "..." : shown;
}

std::string NamesOf(const RobotModel& model) {
  std::string names;
  for (const JointModel& joint : model.joints) names += (names.empty() ? "" : ", ") + joint.name;
  return names;
}

std::string CountsOf(const Ros2JointCommand& command) {
  return fmt::format("{} names, {} positions, {} velocities", command.joints.size(),
                     command.position_rad.size(), command.velocity_rad_s.size());
}

}  // namespace

std::string ReadJointCommand(const Ros2JointCommand& command, const RobotModel& model,
                             std::map<int, JointTarget>* targets) {
  const size_t count = command.joints.size();
  const bool has_speeds = !command.velocity_rad_s.empty();
  if (count == 0) return "names no joint";
  if (command.position_rad.size() != count ||
      (has_speeds && command.velocity_rad_s.size() != count))
    return CountsOf(command) + "; a position for each name, a velocity for each or none";
  std::map<int, JointTarget> read;
  for (size_t i = 0; i < count; ++i) {
    const std::string& name = command.joints[i];
    const int joint = model.FindJoint(name);
    if (joint < 0) {
      return fmt::format("'{}' is no joint of the {}; there are {}", Shown(name), model.name,
                         NamesOf(model));
    }
    JointTarget target{command.position_rad[i]};
    if (has_speeds) target.speed_rad_s = std::abs(command.velocity_rad_s[i]);
    if (!std::isfinite(target.position_rad)) return "the position of " + name + " is no number";
    if (!std::isfinite(target.speed_rad_s)) return "the velocity of " + name + " is no number";
    if (!read.emplace(joint, target).second) return name + " is named twice";
  }
  *targets = std::move(read);
  return "";
}

}  // namespace openr_host
