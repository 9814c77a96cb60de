// RobotServices: the interface between the OPENR:: functions, which objects call, and the simulated
// robot.
//
// Every function has the meaning and the results of the function of the same name in OPENRAPI.h.
// The base class is a robot without devices: its functions return oNOT_SUPPORTED, or the error for
// a primitive or key that does not exist.  The functions are called in handlers of objects, and
// memory that they allocate comes from the host's heap.
#pragma once

#include <OPENR/OPENRAPI.h>

#include <cstdint>
#include <optional>

namespace openr_host {

class Hasher;

class RobotServices {
 public:
  virtual ~RobotServices() = default;

  virtual OStatus OpenPrimitive(const char* locator, OPrimitiveID* id);
  virtual OStatus ClosePrimitive(OPrimitiveID id);
  virtual OStatus ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param,
                                   size_t param_size, void* result, size_t result_size);

  // The parameter `gains` of the functions below has the six numbers of a joint's PID control: P,
  // I, D gain, then P, I, D shift.  A gain acts like gain x 2^(shift - 16) (robot.md 8).
  virtual OStatus EnableJointGain(OPrimitiveID id);
  virtual OStatus DisableJointGain(OPrimitiveID id);
  virtual OStatus SetJointGain(OPrimitiveID id, const word gains[6]);
  virtual OStatus GetJointGain(OPrimitiveID id, word gains[6]);
  virtual OStatus RegisterDefaultJointGain(OPrimitiveID id, const word gains[6]);
  virtual OStatus SetDefaultJointGain(OPrimitiveID id);
  virtual OStatus GetDefaultJointGain(OPrimitiveID id, word gains[6]);

  virtual OStatus GetJointValue(OPrimitiveID id, OJointValue* value);
  virtual OStatus GetSensorValue(OPrimitiveID id, OSensorValue* value);

  virtual OStatus NewSyncKey(OVRSyncKey* key);
  virtual OStatus CancelSyncKey(OVRSyncKey key);
  virtual OStatus DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2);
  virtual OStatus SetCdtVectorData(MemoryRegionID id);

  virtual OStatus SetMotorPower(OPower power);
  virtual OStatus GetBootCondition(OBootCondition* condition);
  virtual OStatus Shutdown(const OBootCondition& condition);
  virtual OStatus GetPowerStatus(OPowerStatus* status);
  virtual OStatus ObservePowerStatus(const OPowerStatus& notify, const OServiceEntry& entry);
  virtual OStatus UnobservePowerStatus(const OServiceEntry& entry);

  virtual OStatus SetTime(const OTime& time);
  virtual OStatus GetTime(OTime* time);
  virtual OStatus SetTimeDifference(sbyte hours);
  virtual OStatus GetTimeDifference(sbyte* hours);
  virtual OStatus SetVolumeSwitch(OVolumeSwitch volume);
  virtual OStatus GetVolumeSwitch(OVolumeSwitch* volume);

  // ---- Functions that the runtime calls, and that objects cannot call

  // Returns the virtual time in us for which the robot stays off after the shutdown that Shutdown()
  // has begun; nullopt if only a person can boot the robot again.
  virtual std::optional<int64_t> TimeOffUs() const { return {}; }
  // Switches the devices off, and sets all their state and settings as at a boot.  Called after the
  // shutdown of a robot that will boot again.
  virtual void SwitchOff() {}
  // Moves the body for one frame while the robot is off.  Called at the end of the frame.
  virtual void RunFrameWhileOff() {}

  // Sets the state of all random generators of the robot as for a new robot with this seed.  Called
  // before System::Boot().
  virtual void Reseed(uint64_t) {}

  // Adds to the state hash all state of the robot that can change what the functions of this class
  // do or return later.
  virtual void HashState(Hasher* hasher) const;
};

}  // namespace openr_host
