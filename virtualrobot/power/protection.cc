#include "virtualrobot/power/protection.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "runtime/base/hasher.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/dynamics/servo.h"

namespace openr_host {
namespace {

// A joint is jammed when its servo demands full drive and the joint turns more slowly than this
// speed.  The number is our choice.
const double kJamSpeed_rad_s = Radians(5);

// Factor by which the file VRCOMM.CFG can lengthen the time for which a joint may be jammed before
// the robot shuts down.  The number is our choice, because no source says how much longer the robot
// then waits (field-notes.md 7.20).
constexpr int kPatience = 5;

}  // namespace

Protection::Protection(const RobotModel& model) : model_(model) { SwitchOff(); }

void Protection::SwitchOff() {
  over_current_ = false;
  exceeded_limit_ = ExceededLimit::kNone;
  jammed_frames_.assign(model_.protection.jam_frames > 0 ? model_.joints.size() : 0, 0);
}

int Protection::jam_frames() const {
  return model_.protection.jam_frames * (is_patient_ ? kPatience : 1);
}

void Protection::FindJam(const BodyState& body, std::vector<Reason>* reasons) {
  for (size_t j = 0; j < jammed_frames_.size(); ++j) {
    const JointState& joint = body.joints[j];
    const bool is_jammed =
        std::fabs(joint.drive) >= kDriveFull && std::fabs(joint.speed_rad_s) < kJamSpeed_rad_s;
    jammed_frames_[j] = is_jammed ? jammed_frames_[j] + 1 : 0;
    // Reports a jam only in the frame in which it reaches the limit, so that a long jam is reported
    // once.
    if (jammed_frames_[j] != jam_frames()) continue;
    const JointModel& model = model_.joints[j];
    reasons->push_back(
        {fmt::format("OVirtualRobotComm: JAM. SHUTDOWN.: {} ({}) is asked for all of its drive and "
                     "does not move for {} ms, the robot shuts down",
                     model.name, model.locator, jam_frames() * 8),
         fmt::format("joint {} was jammed", model.name)});
  }
}

std::vector<Protection::Reason> Protection::NoteFrame(const BodyState& body, const Energy& energy,
                                                      bool charging) {
  std::vector<Reason> reasons;
  FindJam(body, &reasons);
  const Limits& limits = model_.protection;
  const bool over_current = limits.current_ma > 0 && energy.mean_ma() > limits.current_ma;
  if (std::exchange(over_current_, over_current) != over_current && over_current) {
    reasons.push_back(
        {fmt::format("BATTERY_OVER_CURRENT: the battery gives {:.0f} mA, its limit is {} mA; the "
                     "robot shuts down (fast reversals or hard gains?)",
                     energy.mean_ma(), limits.current_ma),
         "the battery gave too much current"});
  }
  const int hot_c = charging ? limits.hot_charging_c : limits.hot_c;
  const int battery_c = energy.Celsius(HeatedPart::kBattery);
  const ExceededLimit heat = hot_c == 0 || battery_c < hot_c ? ExceededLimit::kNone
                             : charging                      ? ExceededLimit::kCharging
                                                             : ExceededLimit::kDischarging;
  if (std::exchange(exceeded_limit_, heat) != heat && heat != ExceededLimit::kNone) {
    reasons.push_back(
        {fmt::format("BATTERY_OVER_TEMP_{}: the battery has {} degrees Celsius, its limit is {}; "
                     "the robot shuts down",
                     charging ? "CHARGING" : "DISCHARGING", battery_c, hot_c),
         fmt::format("the battery had {} degrees Celsius", battery_c)});
  }
  return reasons;
}

void Protection::HashState(Hasher* hasher) const {
  if (over_current_) hasher->Add(over_current_);
  if (exceeded_limit_ != ExceededLimit::kNone) hasher->Add(exceeded_limit_);
  for (size_t j = 0; j < jammed_frames_.size(); ++j) {
    if (jammed_frames_[j] == 0) continue;
    hasher->Add(static_cast<uint64_t>(j));
    hasher->Add(jammed_frames_[j]);
  }
}

}  // namespace openr_host
