// The functions of namespace OPENR: memory of vectors and what the system answers
// itself; everything about devices goes to the robot's RobotServices.
#include <OPENR/OPENRAPI.h>
#include <fmt/format.h>

#include <cstring>

#include "runtime/core/robot_services.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

using namespace openr_host;

namespace {

constexpr size_t kDesignDataMax = size_t{16} << 20;  // the size of the stick
constexpr longword kCpuClockHz = 192'000'000;        // R4300-class CPU of the ERS-210

Robot& CurrentRobot() { return t_current.system->robot(t_current.object->robot); }
RobotServices& Services() { return *CurrentRobot().services; }

// Where things lie in a vector with `count` elements: header, infos, data.
void FillHeader(ODataVectorInfo* info, MemoryRegionID id, ODataType type, size_t info_size,
                size_t data_size, size_t count) {
  info->memRegionID = id;
  info->offset = 0;
  info->totalSize =
      static_cast<longword>(sizeof(ODataVectorInfo) + count * (info_size + data_size));
  info->type = type;
  info->infoOffset = sizeof(ODataVectorInfo);
  info->infoSize = static_cast<longword>(info_size);
  info->maxNumData = static_cast<longword>(count);
  info->numData = 0;
  info->syncKey = ovrsynckeyUNDEF;
}

template <typename Vector>
OStatus NewVector(size_t bytes, MemoryRegionID* id, Vector** base) {
  if (id == nullptr || base == nullptr) return oINVALID_ARG;
  RegionTable& regions = t_current.system->regions();
  *id = regions.New(bytes, t_current.object->id);
  *base = reinterpret_cast<Vector*>(regions.BaseOf(*id));
  return *base == nullptr ? oNO_MEMORY : oSUCCESS;
}

OStatus DeleteVector(MemoryRegionID id, OStatus unknown) {
  return t_current.system->regions().Delete(id) ? oSUCCESS : unknown;
}

}  // namespace

namespace OPENR {

OStatus OpenPrimitive(const char* locator, OPrimitiveID* id) {
  const ApiScope scope;
  if (id == nullptr) return oINVALID_ARG;
  *id = oprimitiveID_UNDEF;
  return locator == nullptr ? oINVALID_ARG : Services().OpenPrimitive(locator, id);
}

OStatus ClosePrimitive(OPrimitiveID id) {
  const ApiScope scope;
  return Services().ClosePrimitive(id);
}

OStatus ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param, size_t paramSize,
                         void* result, size_t resultSize) {
  const ApiScope scope;
  if (paramSize > oprmctrlPARAM_MAX_SIZE) return oINVALID_ARG;
  return Services().ControlPrimitive(id, request, param, paramSize, result, resultSize);
}

OStatus GetJointValue(OPrimitiveID id, OJointValue* value) {
  const ApiScope scope;
  return value == nullptr ? oINVALID_ARG : Services().GetJointValue(id, value);
}

OStatus GetSensorValue(OPrimitiveID id, OSensorValue* value) {
  const ApiScope scope;
  return value == nullptr ? oINVALID_ARG : Services().GetSensorValue(id, value);
}

OStatus NewCommandVectorData(size_t numCommands, MemoryRegionID* memID,
                             OCommandVectorData** baseAddr) {
  const ApiScope scope;
  constexpr size_t kInfo = sizeof(OCommandInfo);
  constexpr size_t kData = sizeof(OCommandData);
  const OStatus status =
      NewVector(sizeof(ODataVectorInfo) + numCommands * (kInfo + kData), memID, baseAddr);
  if (status != oSUCCESS) return status;
  FillHeader(&(*baseAddr)->vectorInfo, *memID, odataCOMMAND_VECTOR, kInfo, kData, numCommands);
  for (size_t i = 0; i < numCommands; ++i) {
    OCommandInfo* const info = (*baseAddr)->GetInfo(static_cast<int>(i));
    info->type = odataUNDEF;
    info->primitiveID = oprimitiveID_UNDEF;
    info->frameNumber = oframeINVALID_NUMBER;
    info->frameSize = sizeof(OCommandValue);
    info->dataOffset =
        static_cast<longword>(sizeof(ODataVectorInfo) + numCommands * kInfo + i * kData);
    info->dataSize = kData;
  }
  return oSUCCESS;
}

OStatus DeleteCommandVectorData(MemoryRegionID memID) {
  const ApiScope scope;
  return DeleteVector(memID, oFAIL);
}

OStatus NewSoundVectorData(size_t numSounds, size_t dataSize, MemoryRegionID* memID,
                           OSoundVectorData** baseAddr) {
  const ApiScope scope;
  constexpr size_t kInfo = sizeof(OSoundInfo);
  const OStatus status =
      NewVector(sizeof(ODataVectorInfo) + numSounds * (kInfo + dataSize), memID, baseAddr);
  if (status != oSUCCESS) return status;
  FillHeader(&(*baseAddr)->vectorInfo, *memID, odataSOUND_VECTOR, kInfo, dataSize, numSounds);
  for (size_t i = 0; i < numSounds; ++i) {
    OSoundInfo* const info = (*baseAddr)->GetInfo(static_cast<int>(i));
    info->primitiveID = oprimitiveID_UNDEF;
    info->dataOffset =
        static_cast<longword>(sizeof(ODataVectorInfo) + numSounds * kInfo + i * dataSize);
    info->maxDataSize = static_cast<longword>(dataSize);
  }
  return oSUCCESS;
}

OStatus DeleteSoundVectorData(MemoryRegionID memID) {
  const ApiScope scope;
  return DeleteVector(memID, oINVALID_ARG);
}

OStatus NewCdtVectorData(MemoryRegionID* memID, OCdtVectorData** baseAddr) {
  const ApiScope scope;
  const OStatus status = NewVector(sizeof(OCdtVectorData), memID, baseAddr);
  if (status != oSUCCESS) return status;
  FillHeader(&(*baseAddr)->vectorInfo, *memID, odataCDT_VECTOR, sizeof(OCdtInfo), 0,
             ocdtNUM_CHANNELS);
  return oSUCCESS;
}

OStatus DeleteCdtVectorData(MemoryRegionID memID) {
  const ApiScope scope;
  return DeleteVector(memID, oFAIL);
}

OStatus SetCdtVectorData(MemoryRegionID memID) {
  const ApiScope scope;
  return Services().SetCdtVectorData(memID);
}

OStatus EnableJointGain(OPrimitiveID id) {
  const ApiScope scope;
  return Services().EnableJointGain(id);
}

OStatus DisableJointGain(OPrimitiveID id) {
  const ApiScope scope;
  return Services().DisableJointGain(id);
}

OStatus SetJointGain(OPrimitiveID id, word pg, word ig, word dg, word ps, word is, word ds) {
  const ApiScope scope;
  const word gains[6] = {pg, ig, dg, ps, is, ds};
  return Services().SetJointGain(id, gains);
}

OStatus GetJointGain(OPrimitiveID id, word* pg, word* ig, word* dg, word* ps, word* is, word* ds) {
  const ApiScope scope;
  word gains[6] = {};
  const OStatus status = Services().GetJointGain(id, gains);
  *pg = gains[0], *ig = gains[1], *dg = gains[2], *ps = gains[3], *is = gains[4], *ds = gains[5];
  return status;
}

OStatus RegisterDefaultJointGain(OPrimitiveID id, word pg, word ig, word dg, word ps, word is,
                                 word ds) {
  const ApiScope scope;
  const word gains[6] = {pg, ig, dg, ps, is, ds};
  return Services().RegisterDefaultJointGain(id, gains);
}

OStatus SetDefaultJointGain(OPrimitiveID id) {
  const ApiScope scope;
  return Services().SetDefaultJointGain(id);
}

OStatus GetDefaultJointGain(OPrimitiveID id, word* pg, word* ig, word* dg, word* ps, word* is,
                            word* ds) {
  const ApiScope scope;
  word gains[6] = {};
  const OStatus status = Services().GetDefaultJointGain(id, gains);
  *pg = gains[0], *ig = gains[1], *dg = gains[2], *ps = gains[3], *is = gains[4], *ds = gains[5];
  return status;
}

OStatus NewSyncKey(OVRSyncKey* key) {
  const ApiScope scope;
  return Services().NewSyncKey(key);
}

OStatus CancelSyncKey(OVRSyncKey key) {
  const ApiScope scope;
  return Services().CancelSyncKey(key);
}

OStatus DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2) {
  const ApiScope scope;
  return Services().DivideSyncKey(key, key1, key2);
}

OStatus SetMotorPower(OPower power) {
  const ApiScope scope;
  return Services().SetMotorPower(power);
}

OStatus Shutdown(const OBootCondition& bootCondition) {
  const ApiScope scope;
  const OStatus status = Services().Shutdown(bootCondition);
  if (status == oSUCCESS || status == oNOT_SUPPORTED) t_current.system->Shutdown(t_current.object->robot);
  return oSUCCESS;
}

OStatus GetBootCondition(OBootCondition* bootCondition) {
  const ApiScope scope;
  return Services().GetBootCondition(bootCondition);
}

OStatus GetPowerStatus(OPowerStatus* powerStatus) {
  const ApiScope scope;
  return Services().GetPowerStatus(powerStatus);
}

OStatus ObservePowerStatus(const OPowerStatus& notifyStatus, const OServiceEntry& entry) {
  const ApiScope scope;
  return Services().ObservePowerStatus(notifyStatus, entry);
}

OStatus UnobservePowerStatus(const OServiceEntry& entry) {
  const ApiScope scope;
  return Services().UnobservePowerStatus(entry);
}

OStatus Fatal(OFatal fatal) {
  const ApiScope scope;
  t_current.system->AddFinding(
      Severity::kError,
      fmt::format("OPENR::Fatal({}): the robot powers off at once, without DoStop",
                  static_cast<int>(fatal)));
  t_current.system->PowerOff(t_current.object->robot);
  return oSUCCESS;
}

OStatus FindDesignData(const char* keyword, ODesignDataID* id, byte** dataAddr, size_t* size) {
  const ApiScope scope;
  if (keyword == nullptr || id == nullptr || dataAddr == nullptr || size == nullptr)
    return oINVALID_ARG;
  *id = odesigndataID_UNDEF;
  if (std::strcmp(keyword, odesignkeywordCPUINFO) == 0) {
    OCPUInfo* cpu = nullptr;
    const OStatus status = NewVector(sizeof(OCPUInfo), id, &cpu);
    if (status != oSUCCESS) return status;
    cpu->sclk = kCpuClockHz / 3;
    cpu->pclk = kCpuClockHz;
    *dataAddr = reinterpret_cast<byte*>(cpu);
    *size = sizeof(OCPUInfo);
    return oSUCCESS;
  }
  const Robot& robot = CurrentRobot();
  const auto found = robot.design_data.find(keyword);
  if (found == robot.design_data.end() || robot.stick == nullptr) return oNOT_FOUND;
  const auto content = robot.stick->ReadFile(found->second);
  if (!content) return oNOT_FOUND;
  if (content->empty()) return oDESIGNDATA_SIZE_ZERO;
  if (content->size() > kDesignDataMax) return oNO_MEMORY;
  const OStatus status = NewVector(content->size(), id, dataAddr);
  if (status != oSUCCESS) return status;
  std::memcpy(*dataAddr, content->data(), content->size());
  *size = content->size();
  return oSUCCESS;
}

OStatus DeleteDesignData(ODesignDataID id) {
  const ApiScope scope;
  return DeleteVector(id, oINVALID_ARG);
}

OStatus GetRobotDesign(char* robotDesign) {
  const ApiScope scope;
  if (robotDesign == nullptr) return oFAIL;
  std::strncpy(robotDesign, CurrentRobot().design.c_str(), orobotdesignNAME_MAX + 1);
  robotDesign[orobotdesignNAME_MAX] = '\0';
  return oSUCCESS;
}

OStatus GetMemoryStickStatus(OMemoryStickStatus* status) {
  const ApiScope scope;
  const MemoryStick* const stick = CurrentRobot().stick.get();
  *status = stick == nullptr    ? omemorystickNOT_EXIST
            : stick->writable() ? omemorystickWRITABLE
                                : omemorystickWRITE_PROTECTED;
  return oSUCCESS;
}

OStatus SetTime(const OTime& time) {
  const ApiScope scope;
  return Services().SetTime(time);
}

OStatus GetTime(OTime* time) {
  const ApiScope scope;
  return Services().GetTime(time);
}

OStatus SetTimeDifference(sbyte timeDif) {
  const ApiScope scope;
  return Services().SetTimeDifference(timeDif);
}

OStatus GetTimeDifference(sbyte* timeDif) {
  const ApiScope scope;
  return Services().GetTimeDifference(timeDif);
}

OStatus SetVolumeSwitch(OVolumeSwitch volume) {
  const ApiScope scope;
  return Services().SetVolumeSwitch(volume);
}

OStatus GetVolumeSwitch(OVolumeSwitch* volume) {
  const ApiScope scope;
  return Services().GetVolumeSwitch(volume);
}

OStatus RequireMWInfo(MWIID) { return oNOT_SUPPORTED; }
OStatus CancelMWInfo(MWIID) { return oNOT_SUPPORTED; }
OStatus IsMWInfoRequired(MWIID, bool* required) {
  *required = false;
  return oNOT_SUPPORTED;
}

}  // namespace OPENR
