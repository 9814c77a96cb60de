#include "dog.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "virtualrobot/base/det_math.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host::motions {
namespace {

constexpr double kMmPerM = 1000;

// Converts a point of the model to the plane of a leg, seen from the leg's J1 axis.  `side` is 1
// for a fore leg and -1 for a hind leg.
LegPoint FromAxis(const Eigen::Vector3d& p_m, const Eigen::Vector3d& axis_m, double side) {
  const Eigen::Vector3d p_mm = kMmPerM * p_m, axis_mm = kMmPerM * axis_m;
  return {side * (p_mm.x() - axis_mm.x()), p_mm.z() - axis_mm.z()};
}

const JointModel& JointOf(const RobotModel& model, const std::string& name) {
  const int index = model.FindJoint(name);
  if (index < 0) throw std::runtime_error(fmt::format("{}: no joint '{}'", model.name, name));
  return model.joints[static_cast<size_t>(index)];
}

const Paw& PawOf(const RobotModel& model, const std::string& leg) {
  for (const Paw& paw : model.paws) {
    if (paw.leg == leg) return paw;
  }
  throw std::runtime_error(fmt::format("{}: no paw of leg '{}'", model.name, leg));
}

Leg LegOfModel(const RobotModel& model, const std::string& name, double side) {
  const Eigen::Vector3d& axis_m = JointOf(model, name + "_j1").anchor_m;
  const LegPoint knee = FromAxis(JointOf(model, name + "_j3").anchor_m, axis_m, side);
  const LegPoint paw = FromAxis(PawOf(model, name).centre_m, axis_m, side);
  return Leg(knee, {paw.out - knee.out, paw.up - knee.up});
}

void SetPitch(double pitch_rad, KeyFrame* frame) {
  frame->attitude_urad[1] = static_cast<int32_t>(std::lround(pitch_rad * 1e6));
}

}  // namespace

Stance Blend(const Stance& from, const Stance& to, double share) {
  const auto mix = [share](double a, double b) { return a + (b - a) * share; };
  return {mix(from.height_mm, to.height_mm), mix(from.pitch_rad, to.pitch_rad),
          mix(from.fore_mm, to.fore_mm), mix(from.hind_mm, to.hind_mm),
          mix(from.tilt_rad, to.tilt_rad)};
}

Dog::Dog(const std::string& model_path) {
  const RobotModel model = LoadRobotModel(model_path);
  robot_ = FindRobot(model.design.c_str());
  if (robot_ == nullptr) {
    throw std::runtime_error(
        fmt::format("{}: design '{}' is not in RobotConstants", model_path, model.design));
  }
  fore_ = LegOfModel(model, "LF", 1);
  hind_ = LegOfModel(model, "LH", -1);
  axis_mm_ = kMmPerM * JointOf(model, "LF_j1").anchor_m.x();
  ball_mm_ = kMmPerM * PawOf(model, "LF").radius_m;
  int next = 0;
  for (int j = 0; j < robot_->numJoints; ++j)
    places_.push_back(robot_->joints[j].mtnIndex >= 0 ? next++ : -1);
  neck_tilt_ = model.FindJoint("neck_tilt") >= 0 ? "neck_tilt" : "neck_tilt1";
  design_label_ = model.mtn_labels.at(0);
}

std::vector<std::string> Dog::Locators() const {
  std::vector<std::string> locators;
  for (int j = 0; j < robot_->numJoints; ++j) {
    if (PlaceOf(j) >= 0) locators.push_back(robot_->joints[j].locator);
  }
  return locators;
}

KeyFrame Dog::FrameOf(const std::string& posture) const {
  const PostureConstants* const found = FindPosture(robot_, posture.c_str());
  if (found == nullptr)
    throw std::runtime_error(fmt::format("the {} has no posture '{}'", robot_->design, posture));
  KeyFrame frame;
  frame.angles_urad.resize(Locators().size());
  for (int j = 0; j < robot_->numJoints; ++j) {
    if (PlaceOf(j) >= 0) frame.angles_urad[static_cast<size_t>(PlaceOf(j))] = found->urad[j];
  }
  SetPitch(StanceOf(posture).pitch_rad, &frame);
  return frame;
}

// Computes the stance from the condition that the balls of the paws touch the floor: the line
// between the centres of a fore and a hind ball is as steep as the body.
Stance Dog::StanceOf(const std::string& posture) const {
  const PostureConstants* const found = FindPosture(robot_, posture.c_str());
  if (found == nullptr)
    throw std::runtime_error(fmt::format("the {} has no posture '{}'", robot_->design, posture));
  const auto angle = [&](const std::string& joint) {
    for (int j = 0; j < robot_->numJoints; ++j) {
      if (robot_->joints[j].name == joint) return found->urad[j] * 1e-6;
    }
    return 0.0;
  };
  const LegPoint fore = fore_.Paw({angle("LF_j1"), angle("LF_j3")});
  const LegPoint hind = hind_.Paw({angle("LH_j1"), angle("LH_j3")});
  const double fore_x = axis_mm_ + fore.out, hind_x = -axis_mm_ - hind.out;
  Stance stance;
  stance.pitch_rad = -std::atan2(fore.up - hind.up, fore_x - hind_x);
  const double c = std::cos(stance.pitch_rad), s = std::sin(stance.pitch_rad);
  stance.fore_mm = fore_x * c - fore.up * s;
  stance.hind_mm = hind_x * c - hind.up * s;
  stance.height_mm = ball_mm_ - (fore_x * s + fore.up * c);
  stance.tilt_rad = angle(neck_tilt_);
  return stance;
}

LegAngles Dog::LegOf(const Leg& leg, double side, const Stance& stance, double place_mm,
                     const PawOffset& offset, const std::string& what) const {
  const double x = place_mm + offset.forward_mm;
  const double z = ball_mm_ + offset.lift_mm - stance.height_mm;
  const double c = std::cos(stance.pitch_rad), s = std::sin(stance.pitch_rad);
  const double body_x = x * c + z * s, body_z = -x * s + z * c;
  return leg.Reach({side * body_x - axis_mm_, body_z}, what);
}

void Dog::Set(KeyFrame* frame, const std::string& joint, double rad,
              const std::string& what) const {
  const int32_t urad = static_cast<int32_t>(std::lround(rad * 1e6));
  for (int j = 0; j < robot_->numJoints; ++j) {
    const JointConstants& limits = robot_->joints[j];
    if (limits.name != joint) continue;
    if (urad < limits.minUrad || urad > limits.maxUrad) {
      throw std::domain_error(
          fmt::format("{}: {} at {:.1f} degrees, its software limits are {:.1f} to {:.1f}", what,
                      joint, Degrees(rad), limits.minCdeg / 100.0, limits.maxCdeg / 100.0));
    }
    frame->angles_urad.at(static_cast<size_t>(PlaceOf(j))) = urad;
    return;
  }
  throw std::runtime_error(fmt::format("the {} has no joint '{}'", robot_->design, joint));
}

KeyFrame Dog::Straight() const {
  KeyFrame frame = FrameOf("stand");
  for (int j = 0; j < robot_->numJoints; ++j) {
    const JointConstants& joint = robot_->joints[j];
    if (PlaceOf(j) >= 0 && joint.minUrad <= 0 && joint.maxUrad >= 0 &&
        std::string_view(joint.name) != "neck_tilt2") {
      frame.angles_urad[static_cast<size_t>(PlaceOf(j))] = 0;
    }
  }
  return frame;
}

KeyFrame Dog::FrameOf(const Stance& stance, const PawOffsets& offsets,
                      const std::string& what) const {
  KeyFrame frame = Straight();
  SetPitch(stance.pitch_rad, &frame);
  Set(&frame, neck_tilt_, stance.tilt_rad, what);
  const struct {
    const char* name;
    const Leg& leg;
    double side, place_mm;
    const PawOffset& offset;
  } legs[] = {{"LF", fore_, 1, stance.fore_mm, offsets.lf},
              {"LH", hind_, -1, stance.hind_mm, offsets.lh},
              {"RF", fore_, 1, stance.fore_mm, offsets.rf},
              {"RH", hind_, -1, stance.hind_mm, offsets.rh}};
  for (const auto& l : legs) {
    const LegAngles angles =
        LegOf(l.leg, l.side, stance, l.place_mm, l.offset, what + ", " + l.name);
    Set(&frame, std::string(l.name) + "_j1", angles.j1_rad, what);
    Set(&frame, std::string(l.name) + "_j3", angles.j3_rad, what);
  }
  return frame;
}

std::vector<KeyFrame> Dog::Way(const Pose& from, const Pose& to, int count,
                               const std::string& what) const {
  const KeyFrame from_solved = FrameOf(from.stance, {}, what),
                 to_solved = FrameOf(to.stance, {}, what);
  std::vector<KeyFrame> frames;
  for (int i = 1; i < count; ++i) {
    const double t = double(i) / count, share = t * t * (3 - 2 * t);
    frames.push_back(FrameOf(Blend(from.stance, to.stance, share), {}, what));
    for (size_t j = 0; j < frames.back().angles_urad.size(); ++j) {
      const double difference =
          (1 - share) * (from.frame.angles_urad[j] - from_solved.angles_urad[j]) +
          share * (to.frame.angles_urad[j] - to_solved.angles_urad[j]);
      frames.back().angles_urad[j] += static_cast<int32_t>(std::lround(difference));
    }
  }
  frames.push_back(to.frame);
  return frames;
}

}  // namespace openr_host::motions
