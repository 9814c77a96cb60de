// The state of everything that command vectors set: joints, lights and ears.
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
  slongword target_urad = 0;       // set point; 0 at boot, wherever the joint is
  bool commanded = false;          // whether a set point has come since boot
  ObjectId commander = kNoObject;  // the object that sent the set point
  bool gain_enabled = false;
  GainWords gains{};                    // all 0 while disabled
  std::optional<GainWords> registered;  // gains kept by RegisterDefaultJointGain()
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

  // Commands to the servos for the coming frame.  Valid until the next call.
  const std::vector<JointCommand>& Commands(bool motor_power);

  // Sets the object whose command vector is applied next.  SetTarget() notes it as the commander.
  void set_commander(ObjectId object) { commander_ = object; }
  void SetTarget(int joint, slongword urad);
  void SetLed2(int led, OLEDValue value);
  void SetLed3(int led, const OLEDCommandValue3& value);

  // Whether the light belongs to the face of an ERS-7.  All lights of a face share one mode: that
  // of the last of them in a command (field-notes.md, 10.1).
  bool OnFace(int led) const { return on_face_[static_cast<size_t>(led)]; }
  void SetFaceMode(OLED3Mode mode);

  // Whether the servo of `joint` moves the joint: it has power and a P gain.
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
  std::vector<bool> on_face_;  // [light]
  std::vector<JointCommand> commands_;
};

}  // namespace openr_host
