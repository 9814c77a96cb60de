#include "virtualrobot/robot/joint_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/base/characters.h"
#include "runtime/base/duration.h"
#include "runtime/base/hasher.h"
#include "runtime/base/spelling.h"
#include "runtime/core/system.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/input_words.h"
#include "virtualrobot/robot/robot_parts.h"

namespace openr_host {
namespace {

std::vector<std::string_view> WordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  for (size_t at = 0; at < text.size();) {
    size_t end = at;
    while (end < text.size() && !IsBlank(text[end])) ++end;
    if (end > at) words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

// If `words`, the words of an input, end with "in DURATION", removes these two words and sets
// `frames` to the duration in frames, at least one.  Returns "" or the error.
std::string TakeInDuration(std::vector<std::string_view>* words, int64_t* frames) {
  const size_t count = words->size();
  if (count < 2 || (*words)[count - 2] != "in") return "";
  int64_t duration_us = 0;
  if (std::string problem = ParseDuration(words->back(), &duration_us); !problem.empty())
    return problem;
  *frames = std::max<int64_t>((duration_us + kFrameUs - 1) / kFrameUs, 1);
  words->resize(count - 2);
  return "";
}

}  // namespace

void JointTargets::AddInputs() {
  robot_.system.inputs().AddKind(
      robot_.robot_index,
      {"target", "target JOINT DEGREES [JOINT DEGREES]... [in DURATION], or target off",
       "Gives servos their set points, in place of the robot's objects, until the joints are "
       "released.",
       [this](int, std::string_view rest, Inputs::Action* action) { return Read(rest, action); }});
}

std::string JointTargets::Read(std::string_view rest, Inputs::Action* action) {
  if (rest == "off") {
    *action = [this] { SwitchOff(); };
    return "";
  }
  std::vector<std::string_view> words = WordsOf(rest);
  int64_t frames = 1;
  if (std::string problem = TakeInDuration(&words, &frames); !problem.empty()) return problem;
  std::vector<Goal> goals;
  if (std::string problem = ReadGoals(words, &goals); !problem.empty()) return problem;
  *action = [this, goals, frames] { Begin(goals, frames); };
  return "";
}

std::string JointTargets::ReadGoals(const std::vector<std::string_view>& words,
                                    std::vector<Goal>* goals) {
  if (words.empty() || words.size() % 2 != 0) return "needs joints, each with an angle in degrees";
  for (size_t i = 0; i < words.size(); i += 2) {
    const int joint = JointNamed(words[i]);
    if (joint < 0) {
      std::vector<std::string> known;
      for (const JointModel& each : robot_.model.joints) known.push_back(each.name);
      return fmt::format("the {} has no joint '{}'{}; it has {}", robot_.model.name, words[i],
                         DidYouMean(std::string(words[i]), known), fmt::join(known, ", "));
    }
    double degrees = 0;
    if (std::string problem = ReadNumber(words[i + 1], &degrees); !problem.empty()) return problem;
    const Range& stops_rad = robot_.model.joints[static_cast<size_t>(joint)].hard_rad;
    const double angle_rad = Radians(degrees);
    if (angle_rad < stops_rad.min || angle_rad > stops_rad.max) {
      return fmt::format("{} degrees is beyond the stops of {}, {:.1f} to {:.1f}", degrees,
                         words[i], Degrees(stops_rad.min), Degrees(stops_rad.max));
    }
    goals->push_back({joint, static_cast<int32_t>(std::lround(angle_rad * 1e6))});
  }
  return "";
}

int JointTargets::JointNamed(std::string_view name) {
  const auto known = known_.find(name);
  if (known != known_.end()) return known->second;
  const int joint = robot_.model.JointNamed(name);
  if (joint >= 0) known_.emplace(name, joint);
  return joint;
}

// Starts to move the set point of each joint in `goals`.  The movement begins at the present set
// point of the joint, or at its measured angle if no set point was sent for the joint since boot.
void JointTargets::Begin(const std::vector<Goal>& goals, int64_t frames) {
  robot_.devices.set_commander(kNoObject);
  // True if DoFrame() has already moved the set points for the frame that begins now.  Begin() must
  // then make the first step of the movement itself.  If DoFrame() still has to run, DoFrame()
  // makes the first step.  A step made here would then be too early: it would move the body in the
  // frame that is just over.
  const bool is_frame_done = frame_begin_us_ == robot_.system.now_us();
  for (const Goal& goal : goals) {
    const auto j = static_cast<size_t>(goal.joint);
    const JointDevice& device = robot_.devices.joints[j];
    const double measured_urad = robot_.body->state().joints[j].angle_rad * 1e6;
    const int32_t from_urad = device.commanded ? static_cast<int32_t>(device.target_urad)
                                               : static_cast<int32_t>(std::lround(measured_urad));
    movements_[goal.joint] = {from_urad, goal.urad, frames, is_frame_done ? 1 : 0};
    if (!is_frame_done) continue;
    const int64_t step_urad = (int64_t{goal.urad} - from_urad) / frames;
    robot_.devices.SetTarget(goal.joint, static_cast<slongword>(from_urad + step_urad));
  }
}

void JointTargets::DoFrame() {
  frame_begin_us_ = robot_.system.now_us();
  if (movements_.empty()) return;
  robot_.devices.set_commander(kNoObject);
  for (auto& [joint, movement] : movements_) {
    movement.done = std::min(movement.done + 1, movement.frames);
    const int64_t whole_urad = int64_t{movement.goal_urad} - movement.from_urad;
    const int64_t urad = movement.from_urad + whole_urad * movement.done / movement.frames;
    robot_.devices.SetTarget(joint, static_cast<slongword>(urad));
  }
}

void JointTargets::HashState(Hasher* hasher) const {
  for (const auto& [joint, movement] : movements_) {
    hasher->Add(joint);
    hasher->Add(movement.from_urad);
    hasher->Add(movement.goal_urad);
    hasher->Add(movement.frames);
    hasher->Add(movement.done);
  }
}

}  // namespace openr_host
