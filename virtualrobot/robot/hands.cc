#include "virtualrobot/robot/hands.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "runtime/base/hasher.h"
#include "runtime/base/spelling.h"
#include "runtime/core/system.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/input_words.h"
#include "virtualrobot/robot/robot_parts.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr int64_t kPushFrames = 13;  // duration of a push without `for DURATION`: about 100 ms
constexpr double kPushMax_n = 1000;  // limit of a push; far more than a robot of 1.4 kg survives
constexpr double kLiftDefault_m = 0.2, kLiftMax_m = 2;
constexpr double kLiftPerFrame_m = 0.2 * kFrame_s;   // a hand lifts with 0.2 m/s
constexpr double kLowerPerFrame_m = 0.1 * kFrame_s;  // a hand lowers with 0.1 m/s
// A hand that sets the robot down lets go when something below carries the robot.  The robot counts
// as carried when it is at least kCarried_m above the pose of the hand and sinks more slowly than
// kCarried_m_s.  The height alone is not enough, because a robot that is lowered follows about half
// a centimetre behind the hand.
constexpr double kCarried_m = 0.015, kCarried_m_s = 0.03;
constexpr double kPutMax_m = 100;
// The strength of a press for which the input gives no number, in percent of the sensor's range.
constexpr int kPressPercent = 50;
// Angle by which a hand turns a joint in a frame: 90 degrees per second.
const double kTurnPerFrame_rad = Radians(90) * kFrame_s;

}  // namespace

void Hands::AddInputs() {
  const auto add = [this](const char* name, const char* usage, const char* help,
                          std::string (Hands::*read)(std::string_view, Inputs::Action*)) {
    robot_.system.inputs().AddKind(
        robot_.robot_index,
        {name, usage, help, [this, read](int, std::string_view rest, Inputs::Action* action) {
           return (this->*read)(rest, action);
         }});
  };
  add("press", "press SENSOR [N%] [for DURATION], or press pause",
      "Presses a sensor that people touch, until it is released, or the pause button.",
      &Hands::ReadPress);
  add("set", "set SENSOR VALUE [for DURATION]",
      "Makes a sensor read a value, in its OPEN-R unit, until it is released.", &Hands::ReadSet);
  add("release", "release SENSOR|JOINT", "Ends press, set, turn and target.", &Hands::ReadRelease);
  add("turn", "turn JOINT DEGREES [for DURATION]",
      "Turns a joint by hand, against its servo, and holds it there until it is released.",
      &Hands::ReadTurn);
  add("push", "push X Y Z [at PART] [for DURATION]",
      "Pushes the robot with a force in N: forward, to its left, up.", &Hands::ReadPush);
  add("lift", "lift [METRES]", "Takes the robot and lifts it, 0.2 m without a number.",
      &Hands::ReadLift);
  add("put", "put THING X Y [Z]",
      "Puts a movable thing of the world somewhere else: X, Y and the height of its middle, in m.",
      &Hands::ReadPut);
  add("battery", "battery N%", "Sets the remaining capacity of the battery.", &Hands::ReadBattery);
  add("charger", "charger on|off", "Puts the robot on its charging station, or takes it away.",
      &Hands::ReadCharger);
  const auto add_plain = [this](const char* name, const char* help, std::function<void()> work) {
    robot_.system.inputs().AddKind(
        robot_.robot_index,
        {name, name, help,
         [work](int, std::string_view rest, Inputs::Action* action) -> std::string {
           *action = work;
           if (!rest.empty()) return fmt::format("takes no '{}'", rest);
           return "";
         }});
  };
  add_plain("hold", "Takes the robot and holds it where it is.", [this] {
    HoldTrunk();
    grip_->goal_z_m = grip_->X_WB.translation().z();
    grip_->sets_down = false;
  });
  add_plain("setdown", "Lowers the robot until something carries it, then lets go.", [this] {
    HoldTrunk();
    grip_->sets_down = true;
  });
  add_plain("letgo", "Lets the robot fall.", [this] { LetGo(); });
}

std::string Hands::FindSensors(const std::string& name, std::vector<int>* sensors) const {
  *sensors = robot_.model.SensorsNamed(name);
  std::vector<std::string> known;
  for (const Sensor& sensor : robot_.model.sensors) {
    if (sensor.joint < 0) known.push_back(sensor.short_name);
  }
  if (sensors->empty()) {
    return fmt::format("the {} has no sensor '{}'{}; it has {}", robot_.model.name, name,
                       DidYouMean(name, known), fmt::join(known, ", "));
  }
  for (const int sensor : *sensors) {
    if (robot_.model.sensors[static_cast<size_t>(sensor)].joint >= 0)
      return fmt::format("'{}' is a joint; its sensor follows the joint", name);
  }
  return "";
}

std::string Hands::ReadPress(std::string_view rest, Inputs::Action* action) {
  std::vector<std::string> words = SplitInput(rest);
  if (words.size() == 1 && words[0] == "pause") {
    // The input "press pause" does nothing if the robot is off, because such a robot does not
    // notice its pause button; only its boot timer boots it again.
    *action = [this] {
      if (!robot_.system.robot(robot_.robot_index).powered_off) robot_.power.PressPause();
    };
    return "";
  }
  std::optional<int64_t> frames;
  if (std::string problem = TakeForDuration(&words, &frames); !problem.empty()) return problem;
  if (words.empty() || words.size() > 2) return "needs one sensor";
  int percent = kPressPercent;
  if (words.size() == 2) {
    if (std::string problem = ReadPercent(words[1], &percent); !problem.empty()) return problem;
  }
  std::vector<int> sensors;
  if (std::string problem = FindSensors(words[0], &sensors); !problem.empty()) return problem;
  std::vector<std::pair<int, int32_t>> values;
  for (const int index : sensors) {
    const Sensor& sensor = robot_.model.sensors[static_cast<size_t>(index)];
    if (sensor.kind == SensorKind::kSwitch) {
      values.emplace_back(index, percent == 0 ? oswitchOFF : oswitchON);
    } else if (sensor.kind == SensorKind::kForce || sensor.kind == SensorKind::kRaw) {
      values.emplace_back(index, static_cast<int32_t>(sensor.max * percent / 100));
    } else {
      return fmt::format("nobody can press '{}'; use set", words[0]);
    }
  }
  *action = [this, values, frames] {
    for (const auto& [sensor, value] : values) Touch(sensor, value, frames);
  };
  return "";
}

std::string Hands::ReadSet(std::string_view rest, Inputs::Action* action) {
  std::vector<std::string> words = SplitInput(rest);
  std::optional<int64_t> frames;
  if (std::string problem = TakeForDuration(&words, &frames); !problem.empty()) return problem;
  if (words.size() != 2) return "needs one sensor and one value";
  std::vector<int> sensors;
  if (std::string problem = FindSensors(words[0], &sensors); !problem.empty()) return problem;
  int32_t value = 0;
  const char* const end = words[1].data() + words[1].size();
  const auto [at, error] = std::from_chars(words[1].data(), end, value);
  if (error != std::errc() || at != end)
    return fmt::format("'{}' is no whole number of 32 bits", words[1]);
  for (const int index : sensors) {
    const Sensor& sensor = robot_.model.sensors[static_cast<size_t>(index)];
    if (sensor.has_range && (value < sensor.min || value > sensor.max)) {
      return fmt::format("{} is outside of what {} measures, {} to {}", value, sensor.short_name,
                         sensor.min, sensor.max);
    }
  }
  *action = [this, sensors, value, frames] {
    for (const int sensor : sensors) Touch(sensor, value, frames);
  };
  return "";
}

std::string Hands::ReadRelease(std::string_view rest, Inputs::Action* action) {
  const std::vector<std::string> words = SplitInput(rest);
  if (words.size() != 1) return "needs one sensor or joint";
  if (const int joint = robot_.model.JointNamed(words[0]); joint >= 0) {
    *action = [this, joint] {
      ReleaseJoint(joint);
      robot_.targets.Release(joint);
    };
    return "";
  }
  std::vector<int> sensors;
  if (std::string problem = FindSensors(words[0], &sensors); !problem.empty()) return problem;
  *action = [this, sensors] {
    for (const int sensor : sensors) Release(sensor);
  };
  return "";
}

std::string Hands::ReadTurn(std::string_view rest, Inputs::Action* action) {
  std::vector<std::string> words = SplitInput(rest);
  Turn turn;
  if (std::string problem = TakeForDuration(&words, &turn.frames); !problem.empty()) return problem;
  if (words.size() != 2) return "needs one joint and one angle in degrees";
  const int joint = robot_.model.JointNamed(words[0]);
  if (joint < 0) {
    std::vector<std::string> known;
    for (const JointModel& each : robot_.model.joints) known.push_back(each.name);
    return fmt::format("the {} has no joint '{}'{}; it has {}", robot_.model.name, words[0],
                       DidYouMean(words[0], known), fmt::join(known, ", "));
  }
  double degrees = 0;
  if (std::string problem = ReadNumber(words[1], &degrees); !problem.empty()) return problem;
  turn.goal_rad = Radians(degrees);
  const Range& stops_rad = robot_.model.joints[static_cast<size_t>(joint)].hard_rad;
  if (turn.goal_rad < stops_rad.min || turn.goal_rad > stops_rad.max) {
    return fmt::format("{} degrees is beyond the stops of {}, {:.1f} to {:.1f}", degrees, words[0],
                       Degrees(stops_rad.min), Degrees(stops_rad.max));
  }
  *action = [this, joint, turn] {
    const auto before = turns_.find(joint);
    // If a hand turns the joint already, the new turn begins at the angle of this hand and not at
    // the angle of the joint, because the joint lags behind the hand.
    const double angle_rad =
        before != turns_.end() ? before->second.angle_rad
                               : robot_.body->state().joints[static_cast<size_t>(joint)].angle_rad;
    turns_[joint] = {angle_rad, turn.goal_rad, turn.frames};
  };
  return "";
}

std::string Hands::ReadPush(std::string_view rest, Inputs::Action* action) {
  std::vector<std::string> words = SplitInput(rest);
  std::optional<int64_t> frames;
  if (std::string problem = TakeForDuration(&words, &frames); !problem.empty()) return problem;
  Push push{0, Vector3d::Zero(), frames.value_or(kPushFrames)};
  if (words.size() == 5 && words[3] == "at") {
    push.part = robot_.model.FindBody(words[4]);
    if (push.part < 0) {
      std::vector<std::string> known;
      for (const BodyPart& part : robot_.model.bodies) known.push_back(part.name);
      return fmt::format("the {} has no part '{}'{}; it has {}", robot_.model.name, words[4],
                         DidYouMean(words[4], known), fmt::join(known, ", "));
    }
    words.resize(3);
  }
  if (words.size() != 3) return "needs three numbers";
  for (int axis = 0; axis < 3; ++axis) {
    if (std::string problem = ReadNumber(words[static_cast<size_t>(axis)], &push.force_B[axis]);
        !problem.empty())
      return problem;
  }
  if (push.force_B.norm() > kPushMax_n) return fmt::format("is limited to {} N", kPushMax_n);
  if (!robot_.body->IsPhysical())
    return "this body has no physics, so a push cannot move it; use --body ode";
  *action = [this, push] { pushes_.push_back(push); };
  return "";
}

std::string Hands::ReadLift(std::string_view rest, Inputs::Action* action) {
  const std::vector<std::string> words = SplitInput(rest);
  double height_m = kLiftDefault_m;
  if (words.size() > 1) return "needs one height";
  if (!words.empty()) {
    if (std::string problem = ReadNumber(words[0], &height_m); !problem.empty()) return problem;
  }
  if (height_m < 0 || height_m > kLiftMax_m)
    return fmt::format("{} m is out of range, 0 to {} m", height_m, kLiftMax_m);
  *action = [this, height_m] {
    HoldTrunk();
    grip_->goal_z_m = grip_->X_WB.translation().z() + height_m;
    grip_->sets_down = false;
  };
  return "";
}

// Reads the name of a thing and then two or three coordinates.  The name may have several words,
// and its last word may be a number.  So first looks for a thing named by all but the last two
// words, and then for a thing named by all but the last three.
std::string Hands::ReadPut(std::string_view rest, Inputs::Action* action) {
  const std::vector<std::string> words = SplitInput(rest);
  if (words.size() < 3) return "needs the name of a thing, and x and y in m";
  const std::vector<WorldThing>& things = robot_.body->world().things;
  const auto named = [&](size_t count) {
    const std::string name =
        fmt::format("{}", fmt::join(words.begin(), words.begin() + count, " "));
    return std::find_if(things.begin(), things.end(), [&name](const WorldThing& each) {
      return each.name == name && each.mass_kg > 0;
    });
  };
  size_t name_words = words.size() - 2;
  auto thing = named(name_words);
  if (thing == things.end() && words.size() > 3) thing = named(--name_words);
  if (thing == things.end()) return NoMovableThingText(rest);
  if (!robot_.body->IsPhysical()) return "things stay where they are with --body ideal";
  Vector3d place(0, 0, thing->centre_m.z());
  for (size_t i = 0; i < words.size() - name_words; ++i) {
    if (std::string problem = ReadNumber(words[name_words + i], &place[i]); !problem.empty())
      return problem;
    if (std::fabs(place[i]) > kPutMax_m)
      return fmt::format("{} m is too far away, at most {} m", place[i], kPutMax_m);
  }
  *action = [this, index = static_cast<size_t>(thing - things.begin()), place] {
    robot_.body->PutThing(index, place);
  };
  return "";
}

// Returns the error message for an input "put" that names no movable thing.  `rest` is the text of
// the input after the word "put".
std::string Hands::NoMovableThingText(std::string_view rest) const {
  std::vector<std::string> known;
  for (const WorldThing& thing : robot_.body->MovableThings()) known.push_back(thing.name);
  if (known.empty()) return "the world has no things that can move";
  const std::string name(rest.substr(0, rest.find(' ')));
  return fmt::format("the world has no movable thing '{}'{}; it has {}", name,
                     DidYouMean(name, known), fmt::join(known, ", "));
}

std::string Hands::ReadBattery(std::string_view rest, Inputs::Action* action) {
  int percent = 0;
  std::string problem = ReadPercent(rest, &percent);
  *action = [this, percent] { robot_.power.SetCapacity(percent); };
  return problem;
}

std::string Hands::ReadCharger(std::string_view rest, Inputs::Action* action) {
  const bool on = rest == "on";
  if (!on && rest != "off") return fmt::format("'{}' is neither on nor off", rest);
  *action = [this, on] { robot_.power.SetCharging(on); };
  return "";
}

void Hands::Touch(int sensor, int32_t value, std::optional<int64_t> frames) {
  robot_.sensors.Hold(sensor, value);
  touches_[sensor] = frames;
}

void Hands::Release(int sensor) {
  robot_.sensors.Release(sensor);
  touches_.erase(sensor);
}

void Hands::ReleaseJoint(int joint) {
  if (turns_.erase(joint) > 0) robot_.devices.Disturbance(joint).hand_rad.reset();
}

// Simulates one frame (8 ms) of the hands that turn joints.
void Hands::MoveJoints() {
  for (auto at = turns_.begin(); at != turns_.end();) {
    auto& [joint, turn] = *at++;  // advances `at` before ReleaseJoint() erases this element
    if (turn.frames && (*turn.frames)-- == 0) {
      ReleaseJoint(joint);
      continue;
    }
    const double way_rad = turn.goal_rad - turn.angle_rad;
    turn.angle_rad += std::clamp(way_rad, -kTurnPerFrame_rad, kTurnPerFrame_rad);
    robot_.devices.Disturbance(joint).hand_rad = turn.angle_rad;
  }
}

// Lets a hand take hold of the robot in its present pose.  Does nothing if a hand holds the robot
// already.
void Hands::HoldTrunk() {
  if (!grip_) grip_ = Grip{robot_.body->state().X_WB, 0, false};
}

void Hands::LetGo() {
  grip_.reset();
  robot_.body->Hold({});
}

// Moves the hand that holds the trunk, for one frame.  A hand that sets the robot down lets go as
// soon as the robot stands or lies on the floor or on a thing.
void Hands::MoveGrip() {
  double& z_m = grip_->X_WB.translation().z();
  if (grip_->sets_down) {
    const BodyState& state = robot_.body->state();
    const bool is_stopped = state.v_WB.z() > -kCarried_m_s;
    if (is_stopped && state.X_WB.translation().z() > z_m + kCarried_m) return LetGo();
    z_m -= kLowerPerFrame_m;
  } else {
    z_m += std::clamp(grip_->goal_z_m - z_m, -kLiftPerFrame_m, kLiftPerFrame_m);
  }
  robot_.body->Hold(grip_->X_WB);
}

void Hands::DoFrame() {
  for (auto touch = touches_.begin(); touch != touches_.end();) {
    const auto now = touch++;  // advances `touch` before Release() erases this element
    if (now->second && (*now->second)-- == 0) Release(now->first);
  }
  for (Push& push : pushes_) {
    const Isometry3d& X_WB = robot_.body->state().X_WB;
    const BodyPart& part = robot_.model.bodies[static_cast<size_t>(push.part)];
    const Isometry3d X_WL = robot_.body->PoseOf(static_cast<size_t>(push.part));
    robot_.body->Push(push.part, X_WB.linear() * push.force_B, X_WL * part.centre_m);
    --push.frames_left;
  }
  std::erase_if(pushes_, [](const Push& push) { return push.frames_left == 0; });
  MoveJoints();
  if (grip_) MoveGrip();
}

void Hands::HashState(Hasher* hasher) const {
  for (const auto& [sensor, frames] : touches_) {
    hasher->Add(sensor);
    hasher->Add(frames.value_or(-1));
  }
  for (const Push& push : pushes_) {
    hasher->Add(push.part);
    hasher->AddBytes(push.force_B.data(), 3 * sizeof(double));
    hasher->Add(push.frames_left);
  }
  for (const auto& [joint, turn] : turns_) {
    hasher->Add(joint);
    hasher->Add(turn.angle_rad);
    hasher->Add(turn.goal_rad);
    hasher->Add(turn.frames.value_or(-1));
  }
  if (!grip_) return;
  hasher->AddBytes(grip_->X_WB.data(), 16 * sizeof(double));
  hasher->Add(grip_->goal_z_m);
  hasher->Add(grip_->sets_down);
}

}  // namespace openr_host
