// The actions of `openr rc` for several joints at a time, and for the motors of joints.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "openr/commands/rc_actions.h"
#include "openr/commands/rc_format.h"
#include "openr/remote/connection.h"
#include "openr/remote/power_format.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// A joint, and the position to which the user wants to move it.
struct JointGoal {
  std::string joint;
  double degrees = 0;
};

JointGoal ParseGoal(const std::string& text) {
  const size_t equals = text.rfind('=');
  JointGoal goal{text.substr(0, equals), 0};
  const char* const end = text.data() + text.size();
  const char* const begin = equals == std::string::npos ? end : text.data() + equals + 1;
  const auto [stop, error] = std::from_chars(begin, end, goal.degrees);
  if (error == std::errc() && stop == end && std::abs(goal.degrees) < 1e6) return goal;
  throw std::runtime_error(
      fmt::format("'{}' is no joint with a number of degrees; write neck_pan=30", text));
}

}  // namespace

void RcPoseAction(remote::Connection* robot, const RcFlags& flags) {
  std::vector<JointGoal> goals;
  // Reads the wanted positions of all joints before the first request to the robot, so that a
  // misspelt position is refused before the robot moves.
  for (const std::string& text : flags.goals) goals.push_back(ParseGoal(text));
  std::vector<remote::Call> calls;
  for (JointGoal& goal : goals) {
    const int joint = robot->Find(rcdeviceJOINT, goal.joint);
    goal.joint = robot->Devices(rcdeviceJOINT)[static_cast<size_t>(joint)].name;
    calls.push_back(remote::Connection::JointCall(rcMOVE, joint, goal.degrees));
  }
  const std::vector<remote::Answer> answers = robot->Batch(calls);
  Json json = Json::object();
  std::string text = fmt::format("{} joints", goals.size());
  for (size_t i = 0; i < goals.size(); ++i) {
    const remote::Answer& answer = answers[i];
    if (answer.status != rcOK) {
      throw remote::Error(answer.status, answer.frame,
                          fmt::format("{}: {}", goals[i].joint, answer.error));
    }
    const double in_force = robot->InForce(answer);
    json[goals[i].joint] = in_force;
    text += fmt::format("\n  {:<12} {:8.2f} deg", goals[i].joint, in_force);
    // Allows the accepted position to differ by a little more than 0.005 degrees from the wanted
    // position, because the robot rounds to hundredths of a degree.
    if (std::abs(in_force - goals[i].degrees) > 0.006) {
      text += fmt::format(", the limit of this joint; {:.2f} asked for", goals[i].degrees);
    }
  }
  PrintRcAnswer(flags.json, robot->frame(), {{"in_force", json}}, text);
}

void RcMotorAction(remote::Connection* robot, const RcFlags& flags) {
  int joint = RC_ALL_JOINTS;
  std::string name = "all motors";
  if (!flags.device.empty()) {
    joint = robot->Find(rcdeviceJOINT, flags.device);
    name = robot->Devices(rcdeviceJOINT)[static_cast<size_t>(joint)].name;
  }
  const bool on = flags.state == "on";
  robot->SwitchMotor(joint, on);
  PrintRcAnswer(flags.json, robot->frame(), {{"motor", name}, {"on", on}},
                fmt::format("{} {}", name, on ? "on" : "off"));
}

void RcGainsAction(remote::Connection* robot, const RcFlags& flags) {
  const int joint = robot->Find(rcdeviceJOINT, flags.device);
  const std::string& name = robot->Devices(rcdeviceJOINT)[static_cast<size_t>(joint)].name;
  const remote::Gains gains =
      flags.gains.size() == 3
          ? robot->SetGains(joint, flags.gains[0], flags.gains[1], flags.gains[2])
          : robot->GetGains(joint);
  const Json json = {{"joint", name},
                     {"on", gains.isOn != 0},
                     {"gains", {gains.gain[0], gains.gain[1], gains.gain[2]}},
                     {"shifts", {gains.shift[0], gains.shift[1], gains.shift[2]}}};
  PrintRcAnswer(flags.json, robot->frame(), json,
                fmt::format("{} gains P {} I {} D {}, shifts {} {} {}{}", name, gains.gain[0],
                            gains.gain[1], gains.gain[2], gains.shift[0], gains.shift[1],
                            gains.shift[2], gains.isOn != 0 ? "" : "; its motor is off"));
}

void RcPowerAction(remote::Connection* robot, const RcFlags& flags) {
  const remote::Power power = robot->GetPower();
  const bool motors = remote::HasMotorPower(power);
  const bool station = remote::IsOnStation(power);
  const Json json = remote::PowerJson(power);
  PrintRcAnswer(
      flags.json, robot->frame(), json,
      fmt::format("motor power {}{}; battery {} % of {} mAh, {:.3f} V, {:.3f} A, {:.2f} degree C; "
                  "robot status {:#010x}, battery status {:#06x}",
                  motors ? "on" : "off", station ? ", on the charging station" : "", power.capacity,
                  power.fullCapacity, power.voltage / 1000.0, power.current / 1000.0,
                  power.temperature / 100.0, power.robotStatus, power.batteryStatus));
}

}  // namespace openr_host
