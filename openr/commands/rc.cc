// openr rc: the remote control on the command line.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "MoverState.h"
#include "openr/commands/commands.h"
#include "openr/commands/rc_format.h"
#include "openr/duration.h"
#include "openr/exit_code.h"
#include "openr/remote_client.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

struct RcFlags {
  std::string address;
  std::string timeout = "3s";
  bool json = false;
  std::string device;
  double value = 0;
  std::string state;
  bool watch = false;
  std::string every = "500ms";
  std::string file;
  int loops = 1;
  int key_frames = 0;
};

// Payload of the requests that set one value of one device.
struct IndexAndValue {
  int index;
  Sint32 value;
  void Write(RcWriter* out) const {
    out->U8(static_cast<Uint32>(index));
    out->S32(value);
  }
};

Sint32 ToCdeg(double degrees) {
  if (!(std::abs(degrees) < 1e6)) throw std::runtime_error("the value is out of range");
  return static_cast<Sint32>(std::lround(degrees * 100));
}

void Say(const RcFlags& flags, uint32_t frame, const Json& json, const std::string& text) {
  if (flags.json) {
    Json answer = {{"frame", FrameJson(frame)}};
    answer.update(json);
    fmt::print("{}\n", answer.dump());
  } else {
    fmt::print("{} {}\n", FrameText(frame), text);
  }
  std::fflush(stdout);
}

void Info(RemoteClient* client, const RcFlags& flags) {
  const RemoteAnswer answer = client->Request(rcINFO);
  const RcInfo info = client->Read<RcInfo>(answer);
  const std::string state = info.state == 0xff ? "starting" : MoverStateName(info.state);
  Say(flags, answer.frame,
      {{"design", info.design},
       {"software", info.software},
       {"state", state},
       {"joints", info.numJoints},
       {"leds", info.numLeds},
       {"ears", info.numEars},
       {"binary_sensors", info.numBinary},
       {"other_sensors", info.numOther}},
      fmt::format("{} with {}, {}: {} joints, {} LEDs, {} ears, {} switches, {} other sensors",
                  info.design, info.software, state, info.numJoints, info.numLeds, info.numEars,
                  info.numBinary, info.numOther));
}

void Get(RemoteClient* client, const RcFlags& flags) {
  const RemoteDevices joints(client, rcdeviceJOINT);
  const int index = joints.Find(flags.device);
  const RemoteAnswer answer = client->Request(rcGET, {static_cast<uint8_t>(index)});
  const RcJointState state = client->Read<RcJointState>(answer);
  const std::string& name = joints.all()[static_cast<size_t>(index)].name;
  Say(flags, answer.frame,
      {{"joint", name},
       {"position_deg", state.position / 100.0},
       {"speed_deg_s", state.speed / 100.0},
       {"acceleration_deg_s2", state.acceleration / 100.0}},
      fmt::format("{} {:.2f} deg, moves with {:.2f} deg/s, {:.2f} deg/s^2", name,
                  state.position / 100.0, state.speed / 100.0, state.acceleration / 100.0));
}

void SetJoint(RemoteClient* client, const RcFlags& flags, int command, const char* unit) {
  const RemoteDevices joints(client, rcdeviceJOINT);
  const int index = joints.Find(flags.device);
  const RemoteAnswer answer =
      client->RequestWith(command, IndexAndValue{index, ToCdeg(flags.value)});
  RcReader reader(answer.payload.data(), static_cast<int>(answer.payload.size()));
  const double in_force = reader.S32() / 100.0;
  const std::string& name = joints.all()[static_cast<size_t>(index)].name;
  const bool limited = std::abs(in_force - flags.value) > 0.0051;
  Say(flags, answer.frame, {{"joint", name}, {"in_force", in_force}, {"limited", limited}},
      fmt::format("{} {:.2f} {}{}", name, in_force, unit,
                  limited ? ", the limit of this joint" : ""));
}

void SetLight(RemoteClient* client, const RcFlags& flags, int command, RcDeviceKind kind) {
  const RemoteDevices devices(client, kind);
  const int index = devices.Find(flags.device);
  const bool on = flags.state == "on";
  const RemoteAnswer answer =
      client->Request(command, {static_cast<uint8_t>(index), static_cast<uint8_t>(on)});
  const std::string& name = devices.all()[static_cast<size_t>(index)].name;
  Say(flags, answer.frame, {{"device", name}, {"on", on}}, fmt::format("{} {}", name, flags.state));
}

void Sensors(RemoteClient* client, const RcFlags& flags) {
  const SensorFormat format(client);
  int64_t every_us = 0;
  const std::string problem = ParseDuration(flags.every, &every_us);
  if (!problem.empty()) throw CLI::ValidationError("--every", problem);
  for (;;) {
    const RemoteAnswer answer = client->Request(rcSENSORS);
    const RcSensors sensors = client->Read<RcSensors>(answer);
    Say(flags, answer.frame, format.ToJson(sensors), format.ToText(sensors));
    if (!flags.watch) return;
    usleep(static_cast<useconds_t>(every_us));
  }
}

void Play(RemoteClient* client, const RcFlags& flags) {
  RcPlayRequest request;
  request.file = flags.file;
  request.loops = static_cast<Uint16>(flags.loops);
  request.keyFramesPerVector = static_cast<Uint8>(flags.key_frames);
  const RemoteAnswer answer = client->RequestWith(rcMTN_PLAY, request);
  const RcPlayAnswer play = client->Read<RcPlayAnswer>(answer);
  Say(flags, answer.frame,
      {{"file", flags.file},
       {"key_frames", play.keyFrames},
       {"loops", play.loops},
       {"duration_s", play.durationMs / 1000.0}},
      fmt::format("plays {}: {} key frames, {:.3f} s, {} times", flags.file, play.keyFrames,
                  play.durationMs / 1000.0, play.loops));
}

void Stop(RemoteClient* client, const RcFlags& flags) {
  const RemoteAnswer answer = client->Request(rcMTN_STOP);
  Say(flags, answer.frame, {{"stopped", true}}, "motion stopped");
}

using Action = std::function<void(RemoteClient*, const RcFlags&)>;

int Perform(const RcFlags& flags, const Action& action) {
  RemoteAddress address;
  std::string problem = ParseRemoteAddress(flags.address, &address);
  if (!problem.empty()) throw CLI::ValidationError("HOST", problem);
  int64_t timeout_us = 0;
  problem = ParseDuration(flags.timeout, &timeout_us);
  if (!problem.empty()) throw CLI::ValidationError("--timeout", problem);
  try {
    RemoteClient client(address, static_cast<int>(timeout_us / 1000));
    action(&client, flags);
    return kExitGood;
  } catch (const RemoteRefusal& refusal) {
    fmt::print(stderr, "openr rc: {} refused: {}\n", FrameText(refusal.frame), refusal.what());
  } catch (const CLI::Error&) {
    throw;
  } catch (const std::exception& error) {
    fmt::print(stderr, "openr rc: {}\n", error.what());
  }
  return kExitWrong;
}

}  // namespace

void AddRcCommand(CLI::App* app, int* exit_code) {
  auto flags = std::make_shared<RcFlags>();
  CLI::App* const rc = app->add_subcommand("rc", "Remote control of a running robot");
  rc->add_option("HOST", flags->address, "Where the robot is: HOST[:PORT]")->required();
  rc->add_option("--timeout", flags->timeout, "How long to wait for an answer")
      ->capture_default_str();
  rc->add_flag("--json", flags->json, "One JSON object per answer");
  rc->require_subcommand(1);
  rc->fallthrough();

  const auto add = [flags, exit_code](CLI::App* to, const char* name, const char* about,
                                      Action action) {
    CLI::App* const command = to->add_subcommand(name, about);
    command->fallthrough();
    command->callback([flags, exit_code, action] { *exit_code = Perform(*flags, action); });
    return command;
  };
  const auto joint = [flags](CLI::App* command, const char* what) {
    command->add_option("JOINT", flags->device, "Name, locator or number")->required();
    if (what != nullptr) command->add_option("VALUE", flags->value, what)->required();
  };
  const auto light = [flags](CLI::App* command) {
    command->add_option("NAME", flags->device, "Name, locator or number")->required();
    command->add_option("STATE", flags->state, "on or off")
        ->required()
        ->check(CLI::IsMember({"on", "off"}));
  };

  add(rc, "info", "What robot this is, and what it does", &Info);
  joint(add(rc, "get", "Position of a joint", &Get), nullptr);
  CLI::App* const sensors = add(rc, "sensors", "All sensor values", &Sensors);
  sensors->add_flag("--watch", flags->watch, "Again and again, until Ctrl-C");
  sensors->add_option("--every", flags->every, "Time between two")->capture_default_str();
  joint(add(rc, "move", "Moves a joint",
            [](RemoteClient* c, const RcFlags& f) { SetJoint(c, f, rcMOVE, "deg"); }),
        "Degrees");
  joint(add(rc, "speed", "Limits the speed of a joint",
            [](RemoteClient* c, const RcFlags& f) { SetJoint(c, f, rcSPEED, "deg/s"); }),
        "Degrees per second");
  joint(add(rc, "accel", "Limits the acceleration of a joint",
            [](RemoteClient* c, const RcFlags& f) { SetJoint(c, f, rcACCEL, "deg/s^2"); }),
        "Degrees per second squared");
  light(add(rc, "led", "Switches a light",
            [](RemoteClient* c, const RcFlags& f) { SetLight(c, f, rcLED, rcdeviceLED); }));
  light(add(rc, "ear", "Moves an ear",
            [](RemoteClient* c, const RcFlags& f) { SetLight(c, f, rcEAR, rcdeviceEAR); }));
  CLI::App* const mtn = rc->add_subcommand("mtn", "Motions on the robot's stick");
  mtn->require_subcommand(1);
  mtn->fallthrough();
  CLI::App* const play = add(mtn, "play", "Plays a motion", &Play);
  play->add_option("FILE", flags->file, "Its name on the stick: WALK.MTN")->required();
  play->add_option("--loops", flags->loops, "How often")
      ->check(CLI::Range(1, 65535))
      ->capture_default_str();
  play->add_option("--keyframes", flags->key_frames,
                   "Key frames per command vector; 0: as the robot likes")
      ->check(CLI::Range(0, 255))
      ->capture_default_str();
  add(mtn, "stop", "Stops the motion", &Stop);
}

}  // namespace openr_host
