#include "dog.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace openr_host::motions {
namespace {

using nlohmann::json;

const json& Row(const json& model, const char* list, const char* key, const std::string& name) {
  for (const json& row : model.at(list).at("rows")) {
    if (row.at(key) == name) return row;
  }
  throw std::runtime_error(fmt::format("no '{}' in '{}'", name, list));
}

// Column x or z of a place, from J1 of the leg.
LegPoint FromAxis(const json& place, const json& axis, double side) {
  return {side * (place.at(0).get<double>() - axis.at(0).get<double>()),
          place.at(2).get<double>() - axis.at(2).get<double>()};
}

// A leg from three places of the model; `side` is 1 for a fore and -1 for a hind leg.
Leg ReadLeg(const json& model, const std::string& name, double side) {
  const json& axis = Row(model, "joints", "name", name + "_j1").at("anchor");
  const LegPoint knee =
      FromAxis(Row(model, "joints", "name", name + "_j3").at("anchor"), axis, side);
  const LegPoint paw = FromAxis(Row(model, "paws", "leg", name).at("centre"), axis, side);
  return Leg(knee, {paw.out - knee.out, paw.up - knee.up});
}

}  // namespace

Stance Blend(const Stance& from, const Stance& to, double share) {
  const auto mix = [share](double a, double b) { return a + (b - a) * share; };
  return {mix(from.height_mm, to.height_mm), mix(from.pitch_rad, to.pitch_rad),
          mix(from.fore_mm, to.fore_mm), mix(from.hind_mm, to.hind_mm),
          mix(from.tilt_rad, to.tilt_rad)};
}

Dog::Dog(const std::string& model_path) {
  std::ifstream file(model_path);
  if (!file) throw std::runtime_error(fmt::format("cannot read robot model {}", model_path));
  try {
    const json model = json::parse(file);
    const std::string design = model.at("design");
    robot_ = FindRobot(design.c_str());
    if (robot_ == nullptr)
      throw std::runtime_error(fmt::format("design '{}' is not in RobotConstants", design));
    fore_ = ReadLeg(model, "LF", 1);
    hind_ = ReadLeg(model, "LH", -1);
    axis_mm_ = Row(model, "joints", "name", "LF_j1").at("anchor").at(0);
    ball_mm_ = Row(model, "paws", "leg", "LF").at("radius");
  } catch (const json::exception& error) {
    throw std::runtime_error(fmt::format("robot model {}: {}", model_path, error.what()));
  }
}

std::vector<std::string> Dog::Locators() const {
  std::vector<std::string> locators;
  for (int j = 0; j < robot_->numJoints; ++j) {
    if (robot_->joints[j].mtnIndex >= 0) locators.push_back(robot_->joints[j].locator);
  }
  return locators;
}

// Place in a key frame; the model lists the joints in the order of the files.
int Dog::IndexOf(const std::string& joint) const {
  for (int j = 0; j < robot_->numJoints; ++j) {
    if (robot_->joints[j].name == joint) return robot_->joints[j].mtnIndex;
  }
  throw std::runtime_error(fmt::format("the {} has no joint '{}'", robot_->design, joint));
}

KeyFrame Dog::FrameOf(const std::string& posture) const {
  const PostureConstants* const found = FindPosture(robot_, posture.c_str());
  if (found == nullptr)
    throw std::runtime_error(fmt::format("the {} has no posture '{}'", robot_->design, posture));
  KeyFrame frame;
  frame.angles_urad.resize(Locators().size());
  for (int j = 0; j < robot_->numJoints; ++j) {
    if (robot_->joints[j].mtnIndex >= 0)
      frame.angles_urad[robot_->joints[j].mtnIndex] = found->urad[j];
  }
  frame.pitch_rad = StanceOf(posture).pitch_rad;
  return frame;
}

// The paws' balls touch the floor: the line between their centres is as steep as the body.
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
  stance.tilt_rad = angle("neck_tilt");
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
                      joint, rad * 180 / M_PI, limits.minCdeg / 100.0, limits.maxCdeg / 100.0));
    }
  }
  frame->angles_urad[IndexOf(joint)] = urad;
}

KeyFrame Dog::FrameOf(const Stance& stance, const PawOffsets& offsets,
                      const std::string& what) const {
  KeyFrame frame;
  frame.angles_urad.assign(Locators().size(), 0);
  frame.pitch_rad = stance.pitch_rad;
  Set(&frame, "neck_tilt", stance.tilt_rad, what);
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
