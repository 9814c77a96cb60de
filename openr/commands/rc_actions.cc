#include "openr/commands/rc_actions.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "MoverState.h"
#include "MtnPlayer.h"
#include "cli/counted.h"
#include "cli/output_file.h"
#include "openr/commands/rc_format.h"
#include "openr/remote/remote_client.h"
#include "openr/remote/remote_log.h"
#include "openr/remote/sensor_format.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// The payload of requests that set a value of a device.
struct IndexAndValue {
  int index;
  Sint32 value;
  void Write(RcWriter* out) const {
    out->U8(static_cast<Uint32>(index));
    out->S32(value);
  }
};

constexpr double kCdegPerDeg = 100;

void Say(const RcFlags& flags, uint32_t frame, const Json& json, const std::string& text) {
  PrintRcAnswer(flags.json, frame, json, text);
}

// Time between two requests for the log.  The robot keeps the records of 8 s of its own time.
constexpr useconds_t kLogPollUs = 5'000;

void WriteLog(const RcFlags& flags, const RemoteLog& log) {
  const std::string problem =
      WriteFile(flags.log, flags.simulated ? SimulatedLog(log.File()) : log.File());
  if (!problem.empty()) throw std::runtime_error(problem);
  std::string text = fmt::format("{} in {}", Counted(log.count(), "key frame"), flags.log);
  if (log.lost() > 0) {
    text += fmt::format("; the robot had dropped {} before", Counted(log.lost(), "other"));
  }
  Say(flags, log.frame(), {{"log", flags.log}, {"records", log.count()}, {"lost", log.lost()}},
      text);
}

// A device of the robot: the index that requests name it by, and its name for messages.
struct Device {
  int index;
  std::string name;
};

Device FindDevice(RemoteClient* client, RcDeviceKind kind, const std::string& name) {
  const RemoteDevices devices(client, kind);
  const int index = devices.Find(name);
  return {index, devices.all()[static_cast<size_t>(index)].name};
}

}  // namespace

void RcInfoAction(RemoteClient* client, const RcFlags& flags) {
  const RemoteAnswer answer = client->Request(rcINFO);
  const RcInfo info = client->Read<RcInfo>(answer);
  const std::string state = StateName(info.state);
  Say(flags, answer.frame,
      {{"design", info.design},
       {"software", info.software},
       {"state", state},
       {"joints", info.numJoints},
       {"leds", info.numLeds},
       {"ears", info.numEars},
       {"binary_sensors", info.numBinary},
       {"other_sensors", info.numOther}},
      fmt::format("{} with {}, {}: {}, {}, {}, {} switch{}, {}", info.design, info.software, state,
                  Counted(info.numJoints, "joint"), Counted(info.numLeds, "LED"),
                  Counted(info.numEars, "ear"), info.numBinary, info.numBinary == 1 ? "" : "es",
                  Counted(info.numOther, "other sensor")));
}

void RcGetAction(RemoteClient* client, const RcFlags& flags) {
  const Device joint = FindDevice(client, rcdeviceJOINT, flags.device);
  const RemoteAnswer answer = client->Request(rcGET, {static_cast<uint8_t>(joint.index)});
  const RcJointState state = client->Read<RcJointState>(answer);
  const double position_deg = state.position / kCdegPerDeg;
  const double speed_deg_s = state.speed / kCdegPerDeg;
  const double acceleration_deg_s2 = state.acceleration / kCdegPerDeg;
  Say(flags, answer.frame,
      {{"joint", joint.name},
       {"position_deg", position_deg},
       {"speed_deg_s", speed_deg_s},
       {"acceleration_deg_s2", acceleration_deg_s2}},
      fmt::format("{} {:.2f} deg, moves with {:.2f} deg/s, {:.2f} deg/s^2", joint.name,
                  position_deg, speed_deg_s, acceleration_deg_s2));
}

RcAction RcJointAction(RcCommand command, const std::string& unit) {
  return [command, unit](RemoteClient* client, const RcFlags& flags) {
    const Device joint = FindDevice(client, rcdeviceJOINT, flags.device);
    const auto asked_cdeg = static_cast<Sint32>(std::lround(flags.value * kCdegPerDeg));
    const RemoteAnswer answer =
        client->RequestWith(command, IndexAndValue{joint.index, asked_cdeg});
    RcReader reader(answer.payload.data(), static_cast<int>(answer.payload.size()));
    const Sint32 in_force_cdeg = reader.S32();
    const double in_force = in_force_cdeg / kCdegPerDeg;
    const bool limited = in_force_cdeg != asked_cdeg;
    const std::string why =
        limited ? fmt::format(", the limit of this joint; {:.2f} asked for", flags.value) : "";
    Say(flags, answer.frame, {{"joint", joint.name}, {"in_force", in_force}, {"limited", limited}},
        fmt::format("{} {:.2f} {}{}", joint.name, in_force, unit, why));
  };
}

RcAction RcLightAction(RcCommand command) {
  return [command](RemoteClient* client, const RcFlags& flags) {
    const RcDeviceKind kind = command == rcLED ? rcdeviceLED : rcdeviceEAR;
    const Device device = FindDevice(client, kind, flags.device);
    const bool asked = flags.state == "on";
    const RemoteAnswer answer =
        client->Request(command, {static_cast<uint8_t>(device.index), static_cast<uint8_t>(asked)});
    RcReader reader(answer.payload.data(), static_cast<int>(answer.payload.size()));
    const bool on = reader.U8() != 0;
    Say(flags, answer.frame, {{"device", device.name}, {"on", on}},
        fmt::format("{} {}", device.name, on ? "on" : "off"));
  };
}

void RcSensorsAction(RemoteClient* client, const RcFlags& flags) {
  const SensorFormat format(client);
  for (;;) {
    const RemoteAnswer answer = client->Request(rcSENSORS);
    const RcSensors sensors = client->Read<RcSensors>(answer);
    Say(flags, answer.frame, format.ToJson(sensors), format.ToText(sensors));
    if (!flags.watch) return;
    usleep(static_cast<useconds_t>(flags.every_us));
  }
}

void RcPlayAction(RemoteClient* client, const RcFlags& flags) {
  if (!flags.with.empty()) return RcPlayWithAction(client, flags);
  RcPlayRequest request;
  request.file = flags.file;
  request.loops = static_cast<Uint16>(flags.loops);
  request.keyFramesPerVector = static_cast<Uint8>(flags.key_frames);
  RemoteLog log(client);
  if (!flags.log.empty()) log.SkipOld();
  const RemoteAnswer answer = client->RequestWith(rcMTN_PLAY, request);
  const RcPlayAnswer play = client->Read<RcPlayAnswer>(answer);
  const int per_vector = flags.key_frames > 0 ? flags.key_frames : DEFAULT_KEYFRAMES_PER_VECTOR;
  Say(flags, answer.frame,
      {{"file", flags.file},
       {"key_frames", play.keyFrames},
       {"loops", play.loops},
       {"duration_s", play.durationMs / 1000.0},
       {"key_frames_per_vector", per_vector}},
      fmt::format("plays {}: {} key frames, {} per vector; {:.3f} s, {}", flags.file,
                  play.keyFrames, per_vector, play.durationMs / 1000.0,
                  play.loops == 1 ? "once" : fmt::format("{} times", play.loops)));
  if (flags.log.empty()) return;
  while (log.Take() != moverACCEPTING_COMMANDS) usleep(kLogPollUs);
  log.Take();  // the last key frames, which may have come before the state
  WriteLog(flags, log);
}

void RcLogAction(RemoteClient* client, const RcFlags& flags) {
  RemoteLog log(client);
  log.Take();
  WriteLog(flags, log);
}

void RcStopAction(RemoteClient* client, const RcFlags& flags) {
  const RemoteAnswer before = client->Request(rcINFO);
  const int state = client->Read<RcInfo>(before).state;
  if (state != moverMTN && state != moverPREPARE_MTN) {
    Say(flags, before.frame, {{"stopped", false}},
        fmt::format("no motion plays ({}): there is nothing to stop", StateName(state)));
    return;
  }
  const RemoteAnswer answer = client->Request(rcMTN_STOP);
  Say(flags, answer.frame, {{"stopped", true}}, "motion stopped");
}

}  // namespace openr_host
