#include "distribution/remote_services.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "distribution/ask_master.h"
#include "runtime/core/region_table.h"

namespace openr_host {

OStatus RemoteServices::OpenPrimitive(const char* locator, OPrimitiveID* id) {
  return AskMaster<&RobotServices::OpenPrimitive>(master_, locator, id);
}

OStatus RemoteServices::ClosePrimitive(OPrimitiveID id) {
  return AskMaster<&RobotServices::ClosePrimitive>(master_, id);
}

OStatus RemoteServices::ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param,
                                         size_t param_size, void* result, size_t result_size) {
  const std::string parameter(static_cast<const char*>(param), param == nullptr ? 0 : param_size);
  const uint64_t wanted = result == nullptr ? 0 : result_size;
  std::string bytes;
  std::string* const to = &bytes;
  const OStatus status =
      AskMaster<&CheckedCalls::ControlPrimitive>(master_, id, request, parameter, wanted, to);
  if (result != nullptr) std::memcpy(result, bytes.data(), std::min(result_size, bytes.size()));
  return status;
}

OStatus RemoteServices::EnableJointGain(OPrimitiveID id) {
  return AskMaster<&RobotServices::EnableJointGain>(master_, id);
}

OStatus RemoteServices::DisableJointGain(OPrimitiveID id) {
  return AskMaster<&RobotServices::DisableJointGain>(master_, id);
}

OStatus RemoteServices::SetJointGain(OPrimitiveID id, const word gains[6]) {
  return AskMaster<&RobotServices::SetJointGain>(master_, id, gains);
}

OStatus RemoteServices::GetJointGain(OPrimitiveID id, word gains[6]) {
  return AskMaster<&RobotServices::GetJointGain>(master_, id, gains);
}

OStatus RemoteServices::RegisterDefaultJointGain(OPrimitiveID id, const word gains[6]) {
  return AskMaster<&RobotServices::RegisterDefaultJointGain>(master_, id, gains);
}

OStatus RemoteServices::SetDefaultJointGain(OPrimitiveID id) {
  return AskMaster<&RobotServices::SetDefaultJointGain>(master_, id);
}

OStatus RemoteServices::GetDefaultJointGain(OPrimitiveID id, word gains[6]) {
  return AskMaster<&RobotServices::GetDefaultJointGain>(master_, id, gains);
}

OStatus RemoteServices::GetJointValue(OPrimitiveID id, OJointValue* value) {
  return AskMaster<&RobotServices::GetJointValue>(master_, id, value);
}

OStatus RemoteServices::GetSensorValue(OPrimitiveID id, OSensorValue* value) {
  return AskMaster<&RobotServices::GetSensorValue>(master_, id, value);
}

OStatus RemoteServices::NewSyncKey(OVRSyncKey* key) {
  return AskMaster<&RobotServices::NewSyncKey>(master_, key);
}

OStatus RemoteServices::CancelSyncKey(OVRSyncKey key) {
  return AskMaster<&RobotServices::CancelSyncKey>(master_, key);
}

OStatus RemoteServices::DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2) {
  return AskMaster<&RobotServices::DivideSyncKey>(master_, key, key1, key2);
}

OStatus RemoteServices::SetCdtVectorData(MemoryRegionID id) {
  const char* const base = regions_->BaseOf(id);
  const std::string bytes(base == nullptr ? "" : base, regions_->SizeOf(id));
  return AskMaster<&CheckedCalls::SetCdtVectorData>(master_, id, bytes);
}

OStatus RemoteServices::SetMotorPower(OPower power) {
  return AskMaster<&RobotServices::SetMotorPower>(master_, power);
}

OStatus RemoteServices::GetBootCondition(OBootCondition* condition) {
  return AskMaster<&RobotServices::GetBootCondition>(master_, condition);
}

OStatus RemoteServices::Shutdown(const OBootCondition& condition) {
  return AskMaster<&RobotServices::Shutdown>(master_, condition);
}

OStatus RemoteServices::GetPowerStatus(OPowerStatus* status) {
  return AskMaster<&RobotServices::GetPowerStatus>(master_, status);
}

OStatus RemoteServices::ObservePowerStatus(const OPowerStatus& notify, const OServiceEntry& entry) {
  return AskMaster<&RobotServices::ObservePowerStatus>(master_, notify, entry);
}

OStatus RemoteServices::UnobservePowerStatus(const OServiceEntry& entry) {
  return AskMaster<&RobotServices::UnobservePowerStatus>(master_, entry);
}

OStatus RemoteServices::SetTime(const OTime& time) {
  return AskMaster<&RobotServices::SetTime>(master_, time);
}

OStatus RemoteServices::GetTime(OTime* time) {
  return AskMaster<&RobotServices::GetTime>(master_, time);
}

OStatus RemoteServices::SetTimeDifference(sbyte hours) {
  return AskMaster<&RobotServices::SetTimeDifference>(master_, hours);
}

OStatus RemoteServices::GetTimeDifference(sbyte* hours) {
  return AskMaster<&RobotServices::GetTimeDifference>(master_, hours);
}

OStatus RemoteServices::SetVolumeSwitch(OVolumeSwitch volume) {
  return AskMaster<&RobotServices::SetVolumeSwitch>(master_, volume);
}

OStatus RemoteServices::GetVolumeSwitch(OVolumeSwitch* volume) {
  return AskMaster<&RobotServices::GetVolumeSwitch>(master_, volume);
}

}  // namespace openr_host
