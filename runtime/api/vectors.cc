// The functions that make and delete vectors: shared memory for commands, sounds and colour
// detection.  A program should make its vectors once and fill them again and again (Level 2
// Reference Guide, section 5; robot.md, 7.2).
#include <OPENR/OPENRAPI.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "runtime/api/region_memory.h"
#include "runtime/core/unset_command.h"

using namespace openr_host;

namespace {

// The number of regions (blocks of shared memory) at which a real robot stopped, because its
// program had made a new vector for every command (field-notes.md, 3.4).
constexpr int kRegionsOfRobot = 0x1cb;
// The number of regions of one object above which a warning is given.  The number is our choice:
// sample programs need two regions per service, so an object with more than 64 probably makes new
// regions again and again.
constexpr int kRegionsOfObject = 64;

// Returns how many regions the objects of `robot` own in total.
int RegionsOfRobot(const System& system, const RegionTable& regions, int robot) {
  int count = 0;
  for (const auto& object : system.objects()) {
    if (object != nullptr && object->robot == robot) count += regions.CountOf(object->id);
  }
  return count;
}

// Warns if the current object has more than kRegionsOfObject regions, because its program seems to
// make a new vector for every command.  With --strict, also shuts the robot down when all its
// objects together have more than kRegionsOfRobot regions, because the real robot stopped then.
void WatchForLeak() {
  System& system = *t_current.system;
  const Object& self = *t_current.object;
  if (system.regions().CountOf(self.id) <= kRegionsOfObject) return;
  system.AddFinding(
      Severity::kWarning,
      fmt::format("a vector is made while this object has more than {} pieces of shared memory: "
                  "make vectors once, in DoInit, and fill them again when NumberOfReference() is "
                  "1; a robot that made one for every command stopped at {} (AttachMemoryRegion "
                  "failed for {:#x} sError = 4)",
                  kRegionsOfObject, kRegionsOfRobot, kRegionsOfRobot));
  if (!system.options().strict ||
      RegionsOfRobot(system, system.regions(), self.robot) <= kRegionsOfRobot)
    return;
  system.AddFinding(
      Severity::kError,
      fmt::format("OObserver::SHManager::GetBaseAddress() AttachMemoryRegion failed for {:#x} "
                  "sError = 4: too much shared memory, the robot shuts down",
                  kRegionsOfRobot));
  system.Shutdown(self.robot, {EndKind::kStrict, self.name + " had too much shared memory"});
}

// Makes a vector: shared memory of `bytes` bytes with a header for `count` elements, each described
// by an info block of `info_size` bytes.  If there is no memory, sets `*base` to null and returns
// oNO_MEMORY.
template <typename Vector>
OStatus NewVector(ODataType type, size_t info_size, size_t bytes, size_t count, MemoryRegionID* id,
                  Vector** base) {
  if (id == nullptr || base == nullptr) return oINVALID_ARG;
  *base = reinterpret_cast<Vector*>(NewSharedMemory(bytes, id));
  if (*base == nullptr) return oNO_MEMORY;
  ODataVectorInfo& info = (*base)->vectorInfo;
  info.memRegionID = *id;
  info.totalSize = static_cast<longword>(bytes);
  info.type = type;
  info.infoOffset = offsetof(Vector, info);
  info.infoSize = static_cast<longword>(info_size);
  info.maxNumData = static_cast<longword>(count);
  info.syncKey = ovrsynckeyUNDEF;
  WatchForLeak();
  return oSUCCESS;
}

// Deletes the vector in region `id`.  If the region is no vector of type `type`, returns `unknown`,
// the error that the calling OPENR::Delete... function has for this case.
OStatus DeleteVector(MemoryRegionID id, ODataType type, OStatus unknown) {
  const RegionTable& regions = t_current.system->regions();
  // If the region was deleted before, calls DeleteSharedMemory(), which then only adds a finding
  // about this mistake of the program.
  if (regions.WasDeleted(id)) DeleteSharedMemory(id);
  if (regions.SizeOf(id) < sizeof(ODataVectorInfo)) return unknown;
  const auto* const info = reinterpret_cast<const ODataVectorInfo*>(regions.BaseOf(id));
  return info->type == type && t_current.system->calls().DeleteRegion(id) ? oSUCCESS : unknown;
}

// Returns the size of `count` elements of `each` bytes, but at most kRobotMemoryBytes (the memory
// of the robot), because the multiplication could overflow.  A vector of this largest size does not
// fit into the robot's memory together with its header, so NewVector() returns oNO_MEMORY.
size_t BytesOf(size_t count, size_t each) {
  return each != 0 && count > kRobotMemoryBytes / each ? kRobotMemoryBytes : count * each;
}

}  // namespace

namespace OPENR {

OStatus NewCommandVectorData(size_t numCommands, MemoryRegionID* memID,
                             OCommandVectorData** baseAddr) {
  const ApiScope scope;
  constexpr size_t kInfo = sizeof(OCommandInfo);
  constexpr size_t kData = sizeof(OCommandData);
  constexpr size_t kHeader = sizeof(ODataVectorInfo);
  const OStatus status =
      NewVector(odataCOMMAND_VECTOR, kInfo, kHeader + BytesOf(numCommands, kInfo + kData),
                numCommands, memID, baseAddr);
  if (status != oSUCCESS) return status;
  for (size_t i = 0; i < numCommands; ++i) {
    OCommandInfo* const info = (*baseAddr)->GetInfo(static_cast<int>(i));
    info->type = odataUNDEF;
    info->primitiveID = oprimitiveID_UNDEF;
    info->frameNumber = oframeINVALID_NUMBER;
    info->frameSize = sizeof(OCommandValue);
    info->dataOffset = static_cast<longword>(kHeader + numCommands * kInfo + i * kData);
    info->dataSize = kData;
    OCommandData* const data = (*baseAddr)->GetData(static_cast<int>(i));
    // Marks the commands as not set, so that the simulated robot can see which of them the program
    // has set (unset_command.h).
    for (OCommandValue& value : data->value) value.value[0] = kUnsetCommand;
  }
  return oSUCCESS;
}

OStatus DeleteCommandVectorData(MemoryRegionID memID) {
  const ApiScope scope;
  return DeleteVector(memID, odataCOMMAND_VECTOR, oFAIL);
}

OStatus NewSoundVectorData(size_t numSounds, size_t dataSize, MemoryRegionID* memID,
                           OSoundVectorData** baseAddr) {
  const ApiScope scope;
  constexpr size_t kInfo = sizeof(OSoundInfo);
  constexpr size_t kHeader = sizeof(ODataVectorInfo);
  const size_t each = kInfo + std::min(dataSize, kRobotMemoryBytes);
  const OStatus status = NewVector(odataSOUND_VECTOR, kInfo, kHeader + BytesOf(numSounds, each),
                                   numSounds, memID, baseAddr);
  if (status != oSUCCESS) return status;
  for (size_t i = 0; i < numSounds; ++i) {
    OSoundInfo* const info = (*baseAddr)->GetInfo(static_cast<int>(i));
    info->primitiveID = oprimitiveID_UNDEF;
    info->frameNumber = oframeINVALID_NUMBER;
    info->dataOffset = static_cast<longword>(kHeader + numSounds * kInfo + i * dataSize);
    info->maxDataSize = static_cast<longword>(dataSize);
  }
  return oSUCCESS;
}

OStatus DeleteSoundVectorData(MemoryRegionID memID) {
  const ApiScope scope;
  return DeleteVector(memID, odataSOUND_VECTOR, oINVALID_ARG);
}

OStatus NewCdtVectorData(MemoryRegionID* memID, OCdtVectorData** baseAddr) {
  const ApiScope scope;
  return NewVector(odataCDT_VECTOR, sizeof(OCdtInfo), sizeof(OCdtVectorData), ocdtNUM_CHANNELS,
                   memID, baseAddr);
}

OStatus DeleteCdtVectorData(MemoryRegionID memID) {
  const ApiScope scope;
  return DeleteVector(memID, odataCDT_VECTOR, oFAIL);
}

}  // namespace OPENR
