#include "virtualrobot/devices.h"

#include "runtime/core/hasher.h"

namespace openr_host {

Devices::Devices(const RobotModel& model)
    : joints(model.joints.size()),
      leds(model.leds.size()),
      plungers(model.plungers.size()),
      commands_(model.joints.size()) {}

const std::vector<JointCommand>& Devices::Commands(bool motor_power) {
  for (size_t i = 0; i < joints.size(); ++i) {
    const JointDevice& joint = joints[i];
    JointCommand& command = commands_[i];
    command.target_rad = joint.target_urad * 1e-6;
    command.enabled = motor_power && joint.gain_enabled;
    command.gains = {joint.gains[0], joint.gains[1], joint.gains[2],
                     joint.gains[3], joint.gains[4], joint.gains[5]};
  }
  return commands_;
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
  return oSUCCESS;
}

void Devices::HashState(Hasher* hasher) const {
  for (const JointDevice& joint : joints) {
    hasher->Add(joint.target_urad);
    hasher->Add(joint.gain_enabled);
    for (const word gain : joint.gains) hasher->Add(gain);
  }
  for (const LedDevice& led : leds) hasher->Add(led.intensity);
  for (const PlungerDevice& plunger : plungers) hasher->Add(plunger.state);
}

}  // namespace openr_host
