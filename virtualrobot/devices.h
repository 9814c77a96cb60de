// The state of everything a command vector can touch: joints, lights, ears.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/OStatus.h>

#include <array>
#include <optional>
#include <vector>

#include "runtime/core/message.h"
#include "virtualrobot/body.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {

class Hasher;

// P, I, D gain, then P, I, D shift, as OPENR::SetJointGain() takes them.
using GainWords = std::array<word, 6>;

struct JointDevice {
  slongword target_urad = 0;       // set point; at boot unrelated to where the joint is
  bool commanded = false;          // a set point has come since boot
  ObjectId commander = kNoObject;  // whose set point it is
  bool gain_enabled = false;
  GainWords gains{};                    // all 0 while disabled
  std::optional<GainWords> registered;  // RegisterDefaultJointGain()
};

struct LedDevice {
  int intensity = 0;  // LED2: 0 or 1; LED3: 0..255
  OLED3Mode mode = oled3_MODE_A;
};

struct PlungerDevice {
  OJointValue3 state = ojoint3_STATE0;
};

class Devices {
 public:
  explicit Devices(const RobotModel& model);

  // What the servos are told for the coming frame.
  const std::vector<JointCommand>& Commands(bool motor_power);

  // Whose command vectors are being applied.
  void set_commander(ObjectId object) { commander_ = object; }
  void SetTarget(int joint, slongword urad);
  void SetLed2(int led, OLEDValue value);
  void SetLed3(int led, const OLEDCommandValue3& value);

  // Lights of the ERS-7's face share one mode: the one given for the last of them in a
  // command (field-notes.md, 10.1).
  bool OnFace(int led) const { return on_face_[static_cast<size_t>(led)]; }
  void SetFaceMode(OLED3Mode mode);

  // Whether the servo of `joint` can move it.
  bool Acts(int joint, bool motor_power) const;

  OStatus EnableGain(int joint);
  OStatus DisableGain(int joint);
  OStatus SetGain(int joint, const GainWords& gains);

  void HashState(Hasher* hasher) const;

  std::vector<JointDevice> joints;
  std::vector<LedDevice> leds;
  std::vector<PlungerDevice> plungers;

 private:
  ObjectId commander_ = kNoObject;
  std::vector<bool> on_face_;  // by light
  std::vector<JointCommand> commands_;
};

}  // namespace openr_host
