#include "virtualrobot/devices/joint_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "runtime/base/hasher.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/dynamics/servo.h"

namespace openr_host {
namespace {

constexpr double kRadPerUrad = 1e-6;
// Distance from which a joint counts as far from its set point.  The number is our choice: a joint
// that is limp (without power) for a moment sags less, so it is not reported.
const double kFar_rad = Radians(10);
// Number of frames in half a second.  A limp joint may sink for two such periods (1 s) without a
// report, because a program needs some time to open the joint and to switch its servo on.  The time
// is our choice.  For example, the head of an ERS-210 sinks 27 degrees in 136 ms, which is no
// mistake of the program.
constexpr int kHalfSecondFrames = 62;
// Smallest change of a set point in one frame that counts as a jump.  The number is our choice.  It
// is above 20 degrees, by which the vendor's own walks change set points in a frame, so that such
// walks are not reported.
const slongword kJumpUrad = static_cast<slongword>(Radians(30) / kRadPerUrad);
// The unit of set points is the microradian.  If the set points of a joint are 1 to 10, positive or
// negative, for 32 frames (a quarter of a second), we assume that the program sends radians by
// mistake, because so few microradians hardly move a joint.  The numbers are our choice.
constexpr slongword kRadianLikeUrad = 10;
constexpr int kRadianLikeFrames = 32;
constexpr double kLoad = 0.78 * kDriveFull;
constexpr int kLoadFrames = 30 * 125;

// Returns the names as a list for a report, such as "PRM:/a, PRM:/b and 10 more".
std::string Listed(const std::vector<std::string>& names) {
  std::string text = names.front();
  if (names.size() > 1) text += fmt::format(", {}", names[1]);
  if (names.size() > 2) text += fmt::format(" and {} more", names.size() - 2);
  return text;
}

}  // namespace

JointWatch::JointWatch(const RobotModel& model, const Devices& devices)
    : model_(model), devices_(devices), joints_(model.joints.size()) {}

void JointWatch::SwitchOff() {
  joints_.assign(joints_.size(), {});
  has_reported_shifts_ = false;
  limp_frames_ = 0;
}

void JointWatch::ServosChanged(const BodyState& body, bool motor_power,
                               std::vector<std::string>* problems) {
  for (size_t j = 0; j < joints_.size(); ++j) {
    const bool acts = devices_.MovesJoint(static_cast<int>(j), motor_power);
    const bool begins = acts && !joints_[j].acted;
    joints_[j].acted = acts;
    const bool has_sunk = HasSunk(joints_[j], devices_.joints[j].target_urad * kRadPerUrad);
    joints_[j].has_acted = joints_[j].has_acted || acts;
    if (!begins || joints_[j].reported_start) continue;
    // Reports nothing in two cases, if an object has sent a set point.  The joint is near the set
    // point, so it does not jump.  Or the joint was limp and has only sunk from the set point,
    // which is no mistake of the program.
    const JointDevice& device = devices_.joints[j];
    const double measured = body.joints[j].angle_rad;
    const double target = device.target_urad * kRadPerUrad;
    if (device.commanded && (std::fabs(target - measured) <= kFar_rad || has_sunk)) continue;
    joints_[j].reported_start = true;
    problems->push_back(fmt::format(
        "{}: its gains take effect {}; the joint is at {:.1f} degrees and goes to {:.1f} at full "
        "power (send a vector with the position of GetJointValue() first)",
        model_.joints[j].locator,
        device.commanded ? "far from its set point" : "before any set point was sent",
        Degrees(measured), Degrees(target)));
  }
}

bool JointWatch::HasSunk(const Joint& joint, double goal_rad) {
  return !joint.has_acted && goal_rad >= std::min(joint.now.low, joint.before.low) - kFar_rad &&
         goal_rad <= std::max(joint.now.high, joint.before.high) + kFar_rad;
}

void JointWatch::NoteLimpJoints(const BodyState& body) {
  const bool next = ++limp_frames_ == kHalfSecondFrames;
  if (next) limp_frames_ = 0;
  for (size_t j = 0; j < joints_.size(); ++j) {
    Joint& joint = joints_[j];
    if (joint.has_acted) continue;
    if (next) joint.before = std::exchange(joint.now, {});
    joint.now.low = std::min(joint.now.low, body.joints[j].angle_rad);
    joint.now.high = std::max(joint.now.high, body.joints[j].angle_rad);
  }
}

void JointWatch::CheckForJump(size_t joint, const CommandElement& element, double measured_rad,
                              std::vector<std::string>* problems) {
  const JointDevice& device = devices_.joints[joint];
  int64_t before =
      device.commanded ? device.target_urad : static_cast<int64_t>(measured_rad / kRadPerUrad);
  for (int i = 0; i < element.frames && !joints_[joint].reported_jump; ++i) {
    const int64_t urad = element.Urad(i);
    if (std::llabs(urad - before) > kJumpUrad) {
      joints_[joint].reported_jump = true;
      problems->push_back(fmt::format(
          "{}: set point jumps from {:.1f} to {:.1f} degrees in one frame; nothing ramps it, the "
          "joint goes there at full power (interpolate, 8 ms a frame)",
          model_.joints[joint].locator, Degrees(static_cast<double>(before) * kRadPerUrad),
          Degrees(static_cast<double>(urad) * kRadPerUrad)));
    }
    before = urad;
  }
}

void JointWatch::CheckForRadians(size_t joint, const CommandElement& element,
                                 std::vector<std::string>* problems) {
  Joint& watched = joints_[joint];
  for (int i = 0; i < element.frames; ++i) {
    const slongword urad = element.Urad(i);
    const bool looks_like_radians =
        urad != 0 && urad >= -kRadianLikeUrad && urad <= kRadianLikeUrad;
    watched.radian_like_frames = looks_like_radians ? watched.radian_like_frames + 1 : 0;
    // Notes whether a set point is larger than kRadianLikeUrad.  No joint can turn by so many
    // radians, so a program that sends such a set point uses microradians.
    watched.was_in_urad = watched.was_in_urad || urad < -kRadianLikeUrad || urad > kRadianLikeUrad;
  }
  if (watched.radian_like_frames < kRadianLikeFrames || watched.reported_radians ||
      watched.was_in_urad)
    return;
  watched.reported_radians = true;
  problems->push_back(
      fmt::format("{}: set points within +-{} are micro-radians and as good as 0; radians are "
                  "multiplied by 1,000,000 (oradians() takes degrees)",
                  model_.joints[joint].locator, kRadianLikeUrad));
}

void JointWatch::CheckShifts(std::vector<std::string>* problems) {
  if (!devices_.HasOneShift() || has_reported_shifts_) return;
  const auto has_gain = [this](size_t j) { return devices_.HasGain(static_cast<int>(j)); };
  size_t first = 0;
  while (first < joints_.size() && !has_gain(first)) ++first;
  for (size_t j = first; j < joints_.size() && !has_reported_shifts_; ++j) {
    const ShiftWords& one = devices_.joints[first].asked_shifts;
    const ShiftWords& other = devices_.joints[j].asked_shifts;
    if (!has_gain(j) || one == other) continue;
    has_reported_shifts_ = true;
    problems->push_back(
        fmt::format("SetJointGain: shifts {} for {} and {} for {}; this robot has one SHIFT for "
                    "all joints, and "
                    "the last call sets it",
                    fmt::join(one, " "), model_.joints[first].locator, fmt::join(other, " "),
                    model_.joints[j].locator));
  }
}

void JointWatch::VectorStarts(const std::vector<CommandElement>& elements, const BodyState& body,
                              bool motor_power, bool motor_power_cut,
                              std::vector<std::string>* problems) {
  CheckShifts(problems);
  // Collects joints without power or gain for one report, because a program that forgets power or
  // gain forgets it for many joints.
  std::vector<std::string> without_power, without_gain;
  for (const CommandElement& element : elements) {
    if (element.primitive == nullptr || element.type != odataJOINT_COMMAND2 || element.frames == 0)
      continue;
    const auto j = static_cast<size_t>(element.primitive->index);
    const double measured = body.joints[j].angle_rad;
    CheckForRadians(j, element, problems);
    if (devices_.MovesJoint(element.primitive->index, motor_power)) {
      CheckForJump(j, element, measured, problems);
      continue;
    }
    const double goal = element.Urad(element.frames - 1) * kRadPerUrad;
    if (joints_[j].reported_no_effect || motor_power_cut ||
        std::fabs(goal - measured) <= kFar_rad || HasSunk(joints_[j], goal))
      continue;
    joints_[j].reported_no_effect = true;
    (motor_power ? without_gain : without_power).push_back(element.primitive->locator);
  }
  if (!without_power.empty()) {
    problems->push_back(fmt::format(
        "set points without effect: motor power is off (OPENR::SetMotorPower(opowerON)): {}",
        Listed(without_power)));
  }
  if (!without_gain.empty()) {
    problems->push_back(fmt::format(
        "set points without effect: no gain (OPENR::EnableJointGain, then SetJointGain): {}",
        Listed(without_gain)));
  }
}

std::vector<int> JointWatch::NoteFrame(const BodyState& body) {
  NoteLimpJoints(body);
  std::vector<int> overloaded;
  for (size_t j = 0; j < joints_.size(); ++j) {
    const double drive = body.joints[j].drive;
    int& frames = joints_[j].loaded_frames;
    frames = drive >= kLoad || drive <= -kLoad ? frames + 1 : 0;
    // Compares for equality, so that a long overload is reported only once.
    if (frames == kLoadFrames) overloaded.push_back(static_cast<int>(j));
  }
  return overloaded;
}

void JointWatch::HashState(Hasher* hasher) const {
  for (const Joint& joint : joints_) hasher->Add(joint.loaded_frames);
}

}  // namespace openr_host
