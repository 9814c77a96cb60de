// The actions of `openr rc` for several joints at a time, and for the motors of joints.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "openr/commands/rc_actions.h"
#include "openr/commands/rc_format.h"
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

}  // namespace openr_host
