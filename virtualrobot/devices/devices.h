// The state of everything that command vectors set: joints, lights, and the plungers that move the
// ears.  A plunger is an actuator with only two positions, on and off.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/OStatus.h>

#include <array>
#include <optional>
#include <vector>

#include "runtime/core/message.h"
#include "virtualrobot/body/body.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {

class Hasher;

// The gains P, I and D, then the shifts of P, I and D, in the order of the parameters of
// OPENR::SetJointGain().
using GainWords = std::array<word, 6>;
// The shifts of the gains P, I and D.  A gain with shift s acts like gain * 2^(s - 16).
using ShiftWords = std::array<word, 3>;

struct JointDevice {
  slongword target_urad = 0;  // set point in 10^-6 rad; 0 at boot, whatever angle the joint has
  bool commanded = false;     // whether an object has sent a set point for this joint since boot
  ObjectId commander = kNoObject;  // the object that sent the set point
  bool gain_enabled = false;
  GainWords gains{};  // gains of the servo; all are 0 while gain_enabled is false
  // The shifts that the last call of SetJointGain() for this joint has asked for.  On an ERS-7 the
  // shifts in `gains` may differ from them, because all joints share one register for the shifts
  // (Devices::HasOneShift()).
  ShiftWords asked_shifts{};
  // The joint's default gains, which RegisterDefaultJointGain() has stored.
  std::optional<GainWords> registered;
};

struct LedDevice {
  int intensity = 0;  // brightness: 0 or 1 for a light of type LED2, 0 to 255 for LED3
  OLED3Mode mode = oled3_MODE_A;
};

struct PlungerDevice {
  OJointValue3 state = ojoint3_STATE0;
};

class Devices {
 public:
  explicit Devices(const RobotModel& model);

  // Returns the commands to the servos for the next frame of 8 ms.  `motor_power` says whether the
  // motors have power.  The result is valid until the next call.
  const std::vector<JointCommand>& Commands(bool motor_power);

  // Returns the disturbance of `joint` by people's hands and by faults, so that the caller can
  // change the disturbance.
  JointDisturbance& Disturbance(int joint);
  // Returns the disturbance of `joint` by people's hands and by faults, for reading only; null when
  // nothing disturbs the joint.
  const JointDisturbance* DisturbanceOf(int joint) const;

  // Sets the object whose command vector is applied next.  SetTarget() stores this object as the
  // commander of the joint.
  void set_commander(ObjectId object) { commander_ = object; }
  void SetTarget(int joint, slongword urad);
  void SetLed2(int led, OLEDValue value);
  void SetLed3(int led, const OLEDCommandValue3& value);

  // Returns whether light `led` belongs to the face of an ERS-7.  All lights of a face share one
  // mode: the mode of the last face light in a command vector (field-notes.md, 10.1).
  bool OnFace(int led) const { return on_face_[static_cast<size_t>(led)]; }
  void SetFaceMode(OLED3Mode mode);

  // Returns whether the servo of `joint` moves the joint: the motors have power, the gains of the
  // joint are enabled (EnableGain()), and the P gain is not 0.
  bool MovesJoint(int joint, bool motor_power) const;

  // Returns whether all joints have one register for the shifts (powers of 2 that scale their
  // gains), so that a change for one joint changes all joints, as on an ERS-7 (field-notes.md
  // 7.15).
  bool HasOneShift() const { return has_one_shift_; }
  // Returns whether a gain of `joint` is not 0.  If all gains are 0, the servo is off and the
  // shifts (powers of 2 that scale the gains) have no effect.
  bool HasGain(int joint) const;

  OStatus EnableGain(int joint);
  OStatus DisableGain(int joint);
  OStatus SetGain(int joint, const GainWords& gains);

  // Sets all devices to their state at boot: lights off, no gains, no set points.
  void SwitchOff();

  void HashState(Hasher* hasher) const;

  std::vector<JointDevice> joints;
  std::vector<LedDevice> leds;
  std::vector<PlungerDevice> plungers;

 private:
  // Gives all joints that have a gain the shifts of `joint` (powers of 2 that scale the gains),
  // because these joints share one register for the shifts.
  void ShareShifts(int joint);

  bool has_one_shift_;  // the result of HasOneShift()
  ObjectId commander_ = kNoObject;
  std::vector<bool> on_face_;  // for each light, the result of OnFace()
  std::vector<JointCommand> commands_;
  // The disturbance of each joint by people's hands and by faults; empty before the first call of
  // Disturbance().
  std::vector<JointDisturbance> disturbances_;
};

}  // namespace openr_host
