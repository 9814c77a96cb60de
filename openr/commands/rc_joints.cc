// The actions of `openr rc` for several joints at a time, and for the motors of joints.
#include <OPENR/OPower.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "openr/commands/rc_actions.h"
#include "openr/commands/rc_format.h"
#include "openr/remote/power_format.h"
#include "openr/remote/remote_client.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kCdegreesPerDegree = 100;

// A joint and the position to which it is to move.
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

void RcPoseAction(RemoteClient* client, const RcFlags& flags) {
  std::vector<JointGoal> goals;
  for (const std::string& text : flags.goals) goals.push_back(ParseGoal(text));
  const RemoteDevices joints(client, rcdeviceJOINT);
  std::vector<RemoteCall> calls;
  for (JointGoal& goal : goals) {
    const int index = joints.Find(goal.joint);
    goal.joint = joints.all()[static_cast<size_t>(index)].name;
    uint8_t bytes[5];
    RcWriter writer(bytes, sizeof bytes);
    writer.U8(static_cast<Uint32>(index));
    writer.S32(static_cast<Sint32>(std::lround(goal.degrees * kCdegreesPerDegree)));
    calls.push_back({rcMOVE, {bytes, bytes + sizeof bytes}});
  }
  const std::vector<RemoteReply> replies = client->Batch(calls);
  Json json = Json::object();
  std::string text = fmt::format("{} joints", goals.size());
  for (size_t i = 0; i < goals.size(); ++i) {
    const RemoteReply& reply = replies[i];
    if (reply.status != rcOK) {
      throw RemoteRefusal(reply.status, reply.answer.frame,
                          fmt::format("{}: {}", goals[i].joint, reply.error));
    }
    const auto& payload = reply.answer.payload;
    RcReader reader(payload.data(), static_cast<int>(payload.size()));
    const double in_force = reader.S32() / kCdegreesPerDegree;
    json[goals[i].joint] = in_force;
    text += fmt::format("\n  {:<12} {:8.2f} deg", goals[i].joint, in_force);
    if (std::abs(in_force - goals[i].degrees) > 0.006) {
      text += fmt::format(", the limit of this joint; {:.2f} asked for", goals[i].degrees);
    }
  }
  PrintRcAnswer(flags.json, replies[0].answer.frame, {{"in_force", json}}, text);
}

void RcMotorAction(RemoteClient* client, const RcFlags& flags) {
  uint8_t joint = RC_ALL_JOINTS;
  std::string name = "all motors";
  if (!flags.device.empty()) {
    const RemoteDevices joints(client, rcdeviceJOINT);
    joint = static_cast<uint8_t>(joints.Find(flags.device));
    name = joints.all()[joint].name;
  }
  client->UseVersion(RC_VERSION_FILES);
  const bool on = flags.state == "on";
  const RemoteAnswer answer = client->Request(on ? rcMOTOR_ON : rcMOTOR_OFF, {joint});
  PrintRcAnswer(flags.json, answer.frame, {{"motor", name}, {"on", on}},
                fmt::format("{} {}", name, on ? "on" : "off"));
}

void RcGainsAction(RemoteClient* client, const RcFlags& flags) {
  const RemoteDevices joints(client, rcdeviceJOINT);
  const int joint = joints.Find(flags.device);
  const std::string& name = joints.all()[static_cast<size_t>(joint)].name;
  client->UseVersion(RC_VERSION_FILES);
  uint8_t bytes[7];
  RcWriter writer(bytes, sizeof bytes);
  writer.U8(static_cast<Uint32>(joint));
  for (const int gain : flags.gains) writer.U16(static_cast<Uint32>(gain));
  const RemoteAnswer answer = client->Request(rcGAINS, {bytes, bytes + writer.Size()});
  const auto gains = client->Read<RcGains>(answer);
  const Json json = {{"joint", name},
                     {"on", gains.isOn != 0},
                     {"gains", {gains.gain[0], gains.gain[1], gains.gain[2]}},
                     {"shifts", {gains.shift[0], gains.shift[1], gains.shift[2]}}};
  PrintRcAnswer(flags.json, answer.frame, json,
                fmt::format("{} gains P {} I {} D {}, shifts {} {} {}{}", name, gains.gain[0],
                            gains.gain[1], gains.gain[2], gains.shift[0], gains.shift[1],
                            gains.shift[2], gains.isOn != 0 ? "" : "; its motor is off"));
}

void RcPowerAction(RemoteClient* client, const RcFlags& flags) {
  client->UseVersion(RC_VERSION_FILES);
  const RemoteAnswer answer = client->Request(rcPOWER);
  const auto power = client->Read<RcPower>(answer);
  const bool motors = (power.robotStatus & orsbMOTOR_POWER) != 0;
  const bool station = (power.robotStatus & orsbSTATION_CONNECTED) != 0;
  const Json json = PowerJson(power);
  PrintRcAnswer(
      flags.json, answer.frame, json,
      fmt::format("motor power {}{}; battery {} % of {} mAh, {:.3f} V, {:.3f} A, {:.2f} degree C; "
                  "robot status {:#010x}, battery status {:#06x}",
                  motors ? "on" : "off", station ? ", on the charging station" : "", power.capacity,
                  power.fullCapacity, power.voltage / 1000.0, power.current / 1000.0,
                  power.temperature / 100.0, power.robotStatus, power.batteryStatus));
}

}  // namespace openr_host
