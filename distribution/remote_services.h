// RemoteServices: the OPENR:: functions about devices (joints, sensors, power) for objects in a
// worker.  Each call is a question to the master, because the master has the robots.
#pragma once

#include "distribution/master_link.h"
#include "runtime/core/robot_services.h"

namespace openr_host {

class RegionTable;

class RemoteServices : public RobotServices {
 public:
  // `regions` has the shared memory of the objects in this process.  Both arguments must outlive
  // this object.
  RemoteServices(MasterLink* master, const RegionTable* regions)
      : master_(master), regions_(regions) {}

  OStatus OpenPrimitive(const char* locator, OPrimitiveID* id) override;
  OStatus ClosePrimitive(OPrimitiveID id) override;
  OStatus ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param,
                           size_t param_size, void* result, size_t result_size) override;
  OStatus EnableJointGain(OPrimitiveID id) override;
  OStatus DisableJointGain(OPrimitiveID id) override;
  OStatus SetJointGain(OPrimitiveID id, const word gains[6]) override;
  OStatus GetJointGain(OPrimitiveID id, word gains[6]) override;
  OStatus RegisterDefaultJointGain(OPrimitiveID id, const word gains[6]) override;
  OStatus SetDefaultJointGain(OPrimitiveID id) override;
  OStatus GetDefaultJointGain(OPrimitiveID id, word gains[6]) override;
  OStatus GetJointValue(OPrimitiveID id, OJointValue* value) override;
  OStatus GetSensorValue(OPrimitiveID id, OSensorValue* value) override;
  OStatus NewSyncKey(OVRSyncKey* key) override;
  OStatus CancelSyncKey(OVRSyncKey key) override;
  OStatus DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2) override;
  OStatus SetCdtVectorData(MemoryRegionID id) override;
  OStatus SetMotorPower(OPower power) override;
  OStatus GetBootCondition(OBootCondition* condition) override;
  OStatus Shutdown(const OBootCondition& condition) override;
  OStatus GetPowerStatus(OPowerStatus* status) override;
  OStatus ObservePowerStatus(const OPowerStatus& notify, const OServiceEntry& entry) override;
  OStatus UnobservePowerStatus(const OServiceEntry& entry) override;
  OStatus SetTime(const OTime& time) override;
  OStatus GetTime(OTime* time) override;
  OStatus SetTimeDifference(sbyte hours) override;
  OStatus GetTimeDifference(sbyte* hours) override;
  OStatus SetVolumeSwitch(OVolumeSwitch volume) override;
  OStatus GetVolumeSwitch(OVolumeSwitch* volume) override;

 private:
  MasterLink* const master_;
  const RegionTable* const regions_;
};

}  // namespace openr_host
