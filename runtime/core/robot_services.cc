#include "runtime/core/robot_services.h"

#include "runtime/base/hasher.h"

namespace openr_host {

OStatus RobotServices::OpenPrimitive(const char*, OPrimitiveID* id) {
  *id = oprimitiveID_UNDEF;
  return oNOT_FOUND;
}
OStatus RobotServices::ClosePrimitive(OPrimitiveID) { return oINVALID_PRIMITIVE_ID; }
OStatus RobotServices::ControlPrimitive(OPrimitiveID, OPrimitiveRequest, void*, size_t, void*,
                                        size_t) {
  return oINVALID_PRIMITIVE_ID;
}
OStatus RobotServices::EnableJointGain(OPrimitiveID) { return oINVALID_PRIMITIVE_ID; }
OStatus RobotServices::DisableJointGain(OPrimitiveID) { return oINVALID_PRIMITIVE_ID; }
OStatus RobotServices::SetJointGain(OPrimitiveID, const word*) { return oINVALID_PRIMITIVE_ID; }
OStatus RobotServices::GetJointGain(OPrimitiveID, word*) { return oINVALID_PRIMITIVE_ID; }
OStatus RobotServices::RegisterDefaultJointGain(OPrimitiveID, const word*) {
  return oINVALID_PRIMITIVE_ID;
}
OStatus RobotServices::SetDefaultJointGain(OPrimitiveID) { return oINVALID_PRIMITIVE_ID; }
OStatus RobotServices::GetDefaultJointGain(OPrimitiveID, word*) { return oFAIL; }
OStatus RobotServices::GetJointValue(OPrimitiveID, OJointValue*) { return oINVALID_PRIMITIVE_ID; }
OStatus RobotServices::GetSensorValue(OPrimitiveID, OSensorValue*) { return oINVALID_PRIMITIVE_ID; }
OStatus RobotServices::NewSyncKey(OVRSyncKey* key) {
  *key = ovrsynckeyUNDEF;
  return oNO_SYNC_KEY;
}
OStatus RobotServices::CancelSyncKey(OVRSyncKey) { return oINVALID_SYNC_KEY; }
OStatus RobotServices::DivideSyncKey(OVRSyncKey, OVRSyncKey* key1, OVRSyncKey* key2) {
  *key1 = *key2 = ovrsynckeyUNDEF;
  return oFAIL;
}
OStatus RobotServices::SetCdtVectorData(MemoryRegionID) { return oNOT_SUPPORTED; }
OStatus RobotServices::SetMotorPower(OPower) { return oNOT_SUPPORTED; }
OStatus RobotServices::GetBootCondition(OBootCondition*) { return oNOT_SUPPORTED; }
OStatus RobotServices::Shutdown(const OBootCondition&) { return oNOT_SUPPORTED; }
OStatus RobotServices::GetPowerStatus(OPowerStatus*) { return oNOT_SUPPORTED; }
OStatus RobotServices::ObservePowerStatus(const OPowerStatus&, const OServiceEntry&) {
  return oNOT_SUPPORTED;
}
OStatus RobotServices::UnobservePowerStatus(const OServiceEntry&) { return oNOT_SUPPORTED; }
OStatus RobotServices::SetTime(const OTime&) { return oNOT_SUPPORTED; }
OStatus RobotServices::GetTime(OTime*) { return oNOT_SUPPORTED; }
OStatus RobotServices::SetTimeDifference(sbyte) { return oNOT_SUPPORTED; }
OStatus RobotServices::GetTimeDifference(sbyte*) { return oNOT_SUPPORTED; }
OStatus RobotServices::SetVolumeSwitch(OVolumeSwitch) { return oNOT_SUPPORTED; }
OStatus RobotServices::GetVolumeSwitch(OVolumeSwitch*) { return oNOT_SUPPORTED; }
void RobotServices::HashState(Hasher*) const {}

}  // namespace openr_host
