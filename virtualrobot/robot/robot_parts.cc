#include "virtualrobot/robot/robot_parts.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/base/hasher.h"
#include "runtime/core/system.h"
#include "virtualrobot/camera/rendered_world.h"

namespace openr_host {
namespace {

// Returns the random generator of the sensor noise of robot number `robot`.  Each robot has a
// generator of its own, so a further robot does not change the noise of other robots.
Rng NoiseOf(int robot, uint64_t seed) { return {seed, fmt::format("robot{}/sensors", robot)}; }

std::unique_ptr<ImageSource> SourceOf(std::unique_ptr<ImageSource> given, const RobotModel& model) {
  return given ? std::move(given) : std::make_unique<RenderedWorld>(model);
}

// Returns the random generator for the errors of those sensors of robot number `robot` that the
// input `break` has made noisy.
Rng FaultNoiseOf(int robot, uint64_t seed) { return {seed, fmt::format("robot{}/faults", robot)}; }

}  // namespace

RobotParts::RobotParts(System* system_in, int robot_index_in, const RobotModel& model_in,
                       std::unique_ptr<Body> body_in, VirtualRobotOptions options)
    : system(*system_in),
      robot_index(robot_index_in),
      model(model_in),
      body(std::move(body_in)),
      shared_frame(options.shared_frame ? std::move(options.shared_frame)
                                        : std::make_shared<SharedFrame>()),
      primitives(model),
      devices(model),
      power(&system, options.battery),
      energy(model),
      protection(model),
      sensors(model, primitives, NoiseOf(robot_index, system.options().seed),
              FaultNoiseOf(robot_index, system.options().seed)),
      watch(model, devices),
      speaker(std::move(options.speaker)),
      microphone(std::move(options.microphone), primitives.IdOf(model.microphone_locator),
                 model.microphone_frames),
      camera(SourceOf(std::move(options.camera), model), model.camera,
             primitives.IdOf(model.camera.locator)),
      safe_posture(model) {
  shared_frame->Add(this);
}

void RobotParts::Warn(std::string text) { system.AddFinding(Severity::kWarning, std::move(text)); }

void RobotParts::SwitchOff() {
  primitives.CloseAll();
  devices.SwitchOff();
  power.SwitchOff();
  sync_keys = {};
  optional = {};
  watch.SwitchOff();
  protection.SwitchOff();
  speaker.SwitchOff(frame);
  safe_posture.SwitchOff();
  targets.SwitchOff();
  {  // makes OVirtualRobotComm the current object: it owns the regions of sensors and camera
    const CurrentScope scope(&system, system.FindObject(robot_index, kVirtualRobotComm));
    sensors.SwitchOff();
    camera.SwitchOff(frame);
  }
  const CurrentScope scope(&system, system.FindObject(robot_index, kVirtualRobotAudioComm));
  microphone.SwitchOff(frame);
  first_frame = frame = 0;
}

std::vector<Protection::Reason> RobotParts::NoteFrame(bool is_on) {
  energy.NoteFrame(*body, devices, power.charging(), is_on);
  sensors.set_body_c(energy.Celsius(HeatedPart::kBody));
  std::vector<Protection::Reason> reasons;
  if (is_on) reasons = protection.NoteFrame(body->state(), energy, power.charging());
  power.SetLoad({energy.current_ma(), energy.Celsius(HeatedPart::kBattery),
                 protection.over_current(), protection.over_temperature()});
  return reasons;
}

void RobotParts::Reseed(uint64_t seed) {
  sensors.set_noise(NoiseOf(robot_index, seed), FaultNoiseOf(robot_index, seed));
}

void RobotParts::UseNoiseOf(int number) {
  const uint64_t seed = system.options().seed;
  sensors.set_noise(NoiseOf(number, seed), FaultNoiseOf(number, seed));
}

void RobotParts::HashState(Hasher* hasher) const {
  hasher->Add(model.content_hash);
  hasher->Add(frame);
  body->HashState(hasher);
  primitives.HashState(hasher);
  devices.HashState(hasher);
  power.HashState(hasher);
  sensors.HashState(hasher);
  sync_keys.HashState(hasher);
  optional.HashState(hasher);
  watch.HashState(hasher);
  speaker.HashState(hasher);
  microphone.HashState(hasher);
  camera.HashState(hasher);
  safe_posture.HashState(hasher);
  hands.HashState(hasher);
  targets.HashState(hasher);
  faults.HashState(hasher);
  energy.HashState(hasher);
  protection.HashState(hasher);
}

}  // namespace openr_host
