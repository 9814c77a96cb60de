#include "virtualrobot/devices/devices.h"

#include <algorithm>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"

namespace openr_host {
namespace {

constexpr int kIntensityMax = 255;
constexpr char kErs7[] = "ERS-7";
constexpr int kNumGains = 3;          // number of gains (P, I and D) before the shifts in GainWords
constexpr char kHead[] = "PRM:/r1/";  // start of the locators of all devices in the head

}  // namespace

Devices::Devices(const RobotModel& model)
    : joints(model.joints.size()),
      leds(model.leds.size()),
      plungers(model.plungers.size()),
      has_one_shift_(model.design == kErs7),
      commands_(model.joints.size()) {
  for (const Led& led : model.leds) {
    on_face_.push_back(led.type == oprimitiveLED3_NAME && led.locator.starts_with(kHead));
  }
}

const std::vector<JointCommand>& Devices::Commands(bool motor_power) {
  for (size_t i = 0; i < joints.size(); ++i) {
    const JointDevice& joint = joints[i];
    JointCommand& command = commands_[i];
    command.target_rad = joint.target_urad * 1e-6;
    command.enabled = motor_power && joint.gain_enabled;
    command.gains = {joint.gains[0], joint.gains[1], joint.gains[2],
                     joint.gains[3], joint.gains[4], joint.gains[5]};
  }
  for (size_t i = 0; i < disturbances_.size(); ++i)
    commands_[i].disturbance = DisturbanceOf(static_cast<int>(i));
  return commands_;
}

JointDisturbance& Devices::Disturbance(int joint) {
  disturbances_.resize(joints.size());
  return disturbances_[static_cast<size_t>(joint)];
}

const JointDisturbance* Devices::DisturbanceOf(int joint) const {
  const auto j = static_cast<size_t>(joint);
  return j < disturbances_.size() && disturbances_[j].Exists() ? &disturbances_[j] : nullptr;
}

void Devices::SwitchOff() {
  joints.assign(joints.size(), {});
  leds.assign(leds.size(), {});
  plungers.assign(plungers.size(), {});
  commander_ = kNoObject;
}

void Devices::SetTarget(int joint, slongword urad) {
  ASSERT(joint >= 0 && static_cast<size_t>(joint) < joints.size(), "joint {}", joint);
  JointDevice& device = joints[static_cast<size_t>(joint)];
  device.target_urad = urad;
  device.commanded = true;
  device.commander = commander_;
}

void Devices::SetLed2(int led, OLEDValue value) {
  leds[static_cast<size_t>(led)].intensity = value == oledON ? 1 : 0;
}

void Devices::SetLed3(int led, const OLEDCommandValue3& value) {
  LedDevice& device = leds[static_cast<size_t>(led)];
  device.intensity = std::clamp<int>(value.intensity, 0, kIntensityMax);
  // If the mode that the command demands is neither A nor B, keeps the old mode of the light, as
  // the robot does.
  if (value.mode == oled3_MODE_A || value.mode == oled3_MODE_B) device.mode = value.mode;
}

void Devices::SetFaceMode(OLED3Mode mode) {
  if (mode != oled3_MODE_A && mode != oled3_MODE_B) return;
  for (size_t i = 0; i < leds.size(); ++i) {
    if (on_face_[i]) leds[i].mode = mode;
  }
}

bool Devices::MovesJoint(int joint, bool motor_power) const {
  const JointDevice& device = joints[static_cast<size_t>(joint)];
  return motor_power && device.gain_enabled && device.gains[0] != 0;
}

bool Devices::HasGain(int joint) const {
  const GainWords& gains = joints[static_cast<size_t>(joint)].gains;
  return std::any_of(gains.begin(), gains.begin() + kNumGains, [](word gain) { return gain != 0; });
}

void Devices::ShareShifts(int joint) {
  const GainWords shared = joints[static_cast<size_t>(joint)].gains;
  for (size_t j = 0; j < joints.size(); ++j) {
    if (!HasGain(static_cast<int>(j))) continue;
    std::copy(shared.begin() + kNumGains, shared.end(), joints[j].gains.begin() + kNumGains);
  }
}

OStatus Devices::EnableGain(int joint) {
  joints[static_cast<size_t>(joint)].gain_enabled = true;
  return oSUCCESS;
}

OStatus Devices::DisableGain(int joint) {
  JointDevice& device = joints[static_cast<size_t>(joint)];
  device.gain_enabled = false;
  device.gains = {};
  return oSUCCESS;
}

OStatus Devices::SetGain(int joint, const GainWords& gains) {
  JointDevice& device = joints[static_cast<size_t>(joint)];
  if (!device.gain_enabled) return oGAIN_DISABLED;
  device.gains = gains;
  std::copy(gains.begin() + kNumGains, gains.end(), device.asked_shifts.begin());
  // Gives the shifts of the joint (powers of 2 that scale the gains) to the other joints only if
  // the joint has a gain that is not 0.  With all gains at 0, the servo is off and its shifts have
  // no effect.
  if (has_one_shift_ && HasGain(joint)) ShareShifts(joint);
  return oSUCCESS;
}

void Devices::HashState(Hasher* hasher) const {
  for (const JointDevice& joint : joints) {
    hasher->Add(joint.target_urad);
    hasher->Add(joint.commanded);
    hasher->Add(joint.gain_enabled);
    for (const word gain : joint.gains) hasher->Add(gain);
  }
  for (const LedDevice& led : leds) {
    hasher->Add(led.intensity);
    hasher->Add(led.mode);
  }
  for (const PlungerDevice& plunger : plungers) hasher->Add(plunger.state);
}

}  // namespace openr_host
