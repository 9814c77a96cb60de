#include "openr/commands/rc_actions.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "MoverState.h"
#include "MtnPlayer.h"
#include "cli/counted.h"
#include "cli/output_file.h"
#include "openr/commands/rc_format.h"
#include "openr/remote/connection.h"
#include "openr/remote/log_reader.h"
#include "openr/remote/sensor_format.h"
#include "openr/remote/token_file.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kCdegPerDeg = 100;

void Say(const RcFlags& flags, uint32_t frame, const Json& json, const std::string& text) {
  PrintRcAnswer(flags.json, frame, json, text);
}

// Time between two requests for new records of a motion's log.  It is short, because the robot
// keeps only the records of the last 8 s of its own time.
constexpr useconds_t kLogPollUs = 5'000;

void WriteLog(const RcFlags& flags, const remote::LogReader& log) {
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

// A device of the robot: its index in requests to the robot, and its name for messages to the user.
struct Device {
  int index;
  std::string name;
};

Device FindDevice(remote::Connection* robot, RcDeviceKind kind, const std::string& name) {
  const int index = robot->Find(kind, name);
  return {index, robot->Devices(kind)[static_cast<size_t>(index)].name};
}

double LimitValue(remote::Connection* robot, RcCommand command, int joint, double value) {
  if (command == rcSPEED) return robot->SetSpeed(joint, value);
  return command == rcACCEL ? robot->SetAcceleration(joint, value) : robot->Move(joint, value);
}

}  // namespace

remote::Options OptionsOf(const RcFlags& flags) {
  return {.timeout = std::chrono::milliseconds(flags.timeout_us / 1000),
          .token = flags.token_file.empty() ? "" : remote::ReadTokenFile(flags.token_file)};
}

void RcInfoAction(remote::Connection* robot, const RcFlags& flags) {
  const remote::Info info = robot->GetInfo();
  const std::string state = remote::StateName(info.state);
  Say(flags, robot->frame(),
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

void RcGetAction(remote::Connection* robot, const RcFlags& flags) {
  const Device joint = FindDevice(robot, rcdeviceJOINT, flags.device);
  const remote::JointState state = robot->GetJoint(joint.index);
  const double position_deg = state.position / kCdegPerDeg;
  const double speed_deg_s = state.speed / kCdegPerDeg;
  const double acceleration_deg_s2 = state.acceleration / kCdegPerDeg;
  Say(flags, robot->frame(),
      {{"joint", joint.name},
       {"position_deg", position_deg},
       {"speed_deg_s", speed_deg_s},
       {"acceleration_deg_s2", acceleration_deg_s2}},
      fmt::format("{} {:.2f} deg, moves with {:.2f} deg/s, {:.2f} deg/s^2", joint.name,
                  position_deg, speed_deg_s, acceleration_deg_s2));
}

RcAction RcJointAction(RcCommand command, const std::string& unit) {
  return [command, unit](remote::Connection* robot, const RcFlags& flags) {
    const Device joint = FindDevice(robot, rcdeviceJOINT, flags.device);
    const double in_force = LimitValue(robot, command, joint.index, flags.value);
    // Compares the accepted value with the wanted value in hundredths of a degree.  The robot has
    // no finer numbers, so a smaller difference comes from rounding and not from a limit.
    const bool limited =
        std::lround(in_force * kCdegPerDeg) != std::lround(flags.value * kCdegPerDeg);
    const std::string why =
        limited ? fmt::format(", the limit of this joint; {:.2f} asked for", flags.value) : "";
    Say(flags, robot->frame(),
        {{"joint", joint.name}, {"in_force", in_force}, {"limited", limited}},
        fmt::format("{} {:.2f} {}{}", joint.name, in_force, unit, why));
  };
}

RcAction RcLightAction(RcCommand command) {
  return [command](remote::Connection* robot, const RcFlags& flags) {
    const RcDeviceKind kind = command == rcLED ? rcdeviceLED : rcdeviceEAR;
    const Device device = FindDevice(robot, kind, flags.device);
    const bool on = flags.state == "on";
    if (command == rcLED) {
      robot->SetLed(device.index, on);
    } else {
      robot->SetEar(device.index, on);
    }
    Say(flags, robot->frame(), {{"device", device.name}, {"on", on}},
        fmt::format("{} {}", device.name, on ? "on" : "off"));
  };
}

void RcSensorsAction(remote::Connection* robot, const RcFlags& flags) {
  const remote::SensorFormat format(robot);
  for (;;) {
    const remote::Sensors sensors = robot->GetSensors();
    Say(flags, robot->frame(), format.ToJson(sensors), format.ToText(sensors));
    if (!flags.watch) return;
    // Does not call usleep(), whose argument of 32 bits cannot express more than 71 minutes.
    std::this_thread::sleep_for(std::chrono::microseconds(flags.every_us));
  }
}

void RcPlayAction(remote::Connection* robot, const RcFlags& flags) {
  if (!flags.with.empty() && !flags.log.empty()) return RcPlayWithAction(robot, flags);
  remote::LogReader log(robot);
  // Skips the records that the robot's log has before the motion begins, because they are of
  // earlier motions.
  if (!flags.log.empty()) log.SkipOld();
  const remote::PlayAnswer play = robot->PlayMotion(flags.file, flags.loops, flags.key_frames);
  const int per_vector = flags.key_frames > 0 ? flags.key_frames : DEFAULT_KEYFRAMES_PER_VECTOR;
  Say(flags, robot->frame(),
      {{"file", flags.file},
       {"key_frames", play.keyFrames},
       {"loops", play.loops},
       {"duration_s", play.durationMs / 1000.0},
       {"key_frames_per_vector", per_vector}},
      fmt::format("plays {}: {} key frames, {} per vector; {:.3f} s, {}", flags.file,
                  play.keyFrames, per_vector, play.durationMs / 1000.0,
                  play.loops == 1 ? "once" : fmt::format("{} times", play.loops)));
  if (flags.log.empty()) return;
  while (log.ReadNewRecords() != moverACCEPTING_COMMANDS) usleep(kLogPollUs);
  // Fetches key frames that the robot recorded between the last ReadNewRecords() and the motion's
  // end.
  log.ReadNewRecords();
  WriteLog(flags, log);
}

void RcLogAction(remote::Connection* robot, const RcFlags& flags) {
  remote::LogReader log(robot);
  log.ReadNewRecords();
  WriteLog(flags, log);
}

void RcStopAction(remote::Connection* robot, const RcFlags& flags) {
  const int state = robot->GetInfo().state;
  if (state != moverMTN && state != moverPREPARE_MTN) {
    Say(flags, robot->frame(), {{"stopped", false}},
        fmt::format("no motion plays ({}): there is nothing to stop", remote::StateName(state)));
    return;
  }
  robot->StopMotion();
  Say(flags, robot->frame(), {{"stopped", true}}, "motion stopped");
}

}  // namespace openr_host
