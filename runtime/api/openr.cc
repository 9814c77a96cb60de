// The functions of namespace OPENR, except the functions that make and delete vectors (vectors.cc).
// Functions about devices call the RobotServices of the robot, the interface to its simulated
// devices.  The other functions do their work in this file.
#include <OPENR/OPENRAPI.h>
#include <fmt/format.h>

#include <cstring>
#include <string>
#include <utility>

#include "runtime/api/region_memory.h"
#include "runtime/core/robot_services.h"
#include "runtime/core/system.h"
#include "runtime/stick/gzip.h"
#include "runtime/stick/memory_stick.h"

using namespace openr_host;

namespace {

constexpr longword kCpuClockHz = 192'000'000;  // clock of the ERS-210's CPU (R4300 class)

Robot& CurrentRobot() { return t_current.system->robot(t_current.object->robot); }
RobotServices& Services() { return *CurrentRobot().services; }

// Returns the text with which the report of a run tells that OPENR::Shutdown() has ended the run.
// With a boot timer in `condition` (robot.md 15.3) the robot should boot again later, but this text
// is used only if robots in this run cannot boot again.  So the text then tells the user to start
// the run again.
std::string HowItEnds(const OBootCondition& condition) {
  return (condition.bitmap & obcbBOOT_TIMER) == 0 ? " shut the robot down (OPENR::Shutdown)"
                                                  : " shut the robot down (OPENR::Shutdown) to "
                                                    "boot again, but robots in this run cannot "
                                                    "boot again; start the run again to boot it";
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
  // A robot without devices is shut down too, although its Services().Shutdown() returns
  // oNOT_SUPPORTED.
  if (status == oSUCCESS || status == oNOT_SUPPORTED)
    t_current.system->Shutdown(
        t_current.object->robot,
        {EndKind::kPowerOff, t_current.object->name + HowItEnds(bootCondition)});
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
  const std::string call = fmt::format("OPENR::Fatal({})", static_cast<int>(fatal));
  t_current.system->AddFinding(Severity::kError,
                               call + ": the robot powers off at once, without DoStop");
  t_current.system->PowerOff(t_current.object->robot,
                             {EndKind::kFatal, t_current.object->name + " called " + call});
  return oSUCCESS;
}

OStatus FindDesignData(const char* keyword, ODesignDataID* id, byte** dataAddr, size_t* size) {
  const ApiScope scope;
  if (keyword == nullptr || id == nullptr || dataAddr == nullptr || size == nullptr)
    return oINVALID_ARG;
  *id = odesigndataID_UNDEF;
  if (std::strcmp(keyword, odesignkeywordCPUINFO) == 0) {
    auto* const cpu = reinterpret_cast<OCPUInfo*>(NewSharedMemory(sizeof(OCPUInfo), id));
    if (cpu == nullptr) return oNO_MEMORY;
    cpu->sclk = kCpuClockHz / 3;
    cpu->pclk = kCpuClockHz;
    *dataAddr = reinterpret_cast<byte*>(cpu);
    *size = sizeof(OCPUInfo);
    return oSUCCESS;
  }
  const Robot& robot = CurrentRobot();
  const auto found = robot.design_data.find(keyword);
  if (found == robot.design_data.end() || robot.stick == nullptr) return oNOT_FOUND;
  auto content = robot.stick->ReadFile(found->second);
  if (!content) return oNOT_FOUND;
  // Decompresses the file with design data if it is a gzip file, as the robot does before a program
  // gets the file.
  if (IsGzip(*content)) {
    std::string packed = std::move(*content);
    content->clear();
    if (Gunzip(packed, &*content) != GzipResult::kWhole) return oFAIL;
  }
  if (content->empty()) return oDESIGNDATA_SIZE_ZERO;
  char* const memory = NewSharedMemory(content->size(), id);
  if (memory == nullptr) return oNO_MEMORY;
  std::memcpy(memory, content->data(), content->size());
  *dataAddr = reinterpret_cast<byte*>(memory);
  *size = content->size();
  return oSUCCESS;
}

OStatus DeleteDesignData(ODesignDataID id) {
  const ApiScope scope;
  return DeleteSharedMemory(id) ? oSUCCESS : oINVALID_ARG;
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

// The functions about MWInfo, an information service of OPEN-R, return oNOT_SUPPORTED, because the
// service belongs to level 1 of OPEN-R, for which there is no document (core.md 6.1).
OStatus RequireMWInfo(MWIID) { return oNOT_SUPPORTED; }
OStatus CancelMWInfo(MWIID) { return oNOT_SUPPORTED; }
OStatus IsMWInfoRequired(MWIID, bool* required) {
  *required = false;
  return oNOT_SUPPORTED;
}

}  // namespace OPENR
