// The state of everything a command vector can touch: joints, lights, ears.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/OStatus.h>

#include <array>
#include <optional>
#include <vector>

#include "virtualrobot/body.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {

class Hasher;

// P, I, D gain, then P, I, D shift, as OPENR::SetJointGain() takes them.
using GainWords = std::array<word, 6>;

struct JointDevice {
  slongword target_urad = 0;  // set point; at boot unrelated to where the joint is
  bool gain_enabled = false;
  GainWords gains{};                    // all 0 while disabled
  std::optional<GainWords> registered;  // RegisterDefaultJointGain()
};

struct LedDevice {
  int intensity = 0;  // LED2: 0 or 1; LED3: 0..255
};

struct PlungerDevice {
  OJointValue3 state = ojoint3_STATE0;
};

class Devices {
 public:
  explicit Devices(const RobotModel& model);

  // What the servos are told for the coming frame.
  const std::vector<JointCommand>& Commands(bool motor_power);

  OStatus EnableGain(int joint);
  OStatus DisableGain(int joint);
  OStatus SetGain(int joint, const GainWords& gains);

  void HashState(Hasher* hasher) const;

  std::vector<JointDevice> joints;
  std::vector<LedDevice> leds;
  std::vector<PlungerDevice> plungers;

 private:
  std::vector<JointCommand> commands_;
};

}  // namespace openr_host
