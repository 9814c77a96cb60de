// The functions of MCOOP.h for private and shared memory.  MCOOP.h is the interface of Aperios, the
// robot's operating system.
#include <MCOOP.h>
#include <fmt/format.h>

#include <cstring>

#include "runtime/api/region_memory.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

using namespace openr_host;

namespace {

// The page size in bytes that GetPageSize() returns.  A robot with memory protection has pages of
// this size (Programmer's Guide, 4.1.2).
constexpr size_t kPageBytes = 4096;

// Gives region `id`, which the current object must own, the new size `size`.  If `grows` is true
// (GrowMemoryRegion()), the new size must not be smaller than the old size.  Otherwise
// (ShrinkMemoryRegion()), the new size must be smaller.
sError Resize(MemoryRegionID id, size_t size, bool grows) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  RegionTable& regions = t_current.system->regions();
  if (regions.BaseOf(id) == nullptr) return sINVALIDSHAREDMEMID;
  if (regions.OwnerOf(id) != t_current.object->id) return sPERMISSIONDENIEDSHAREDMEM;
  if (size == 0 || (size < regions.SizeOf(id)) == grows) return sINVALIDARG;
  return t_current.system->calls().ResizeRegion(id, size) ? sSUCCESS : sNOMEMORY;
}

}  // namespace

extern "C" {

sError NewRegion(size_t size, void** base) {
  const ApiScope scope;
  if (t_current.object == nullptr || base == nullptr) return sINVALIDARG;
  *base = nullptr;
  if (size > kRobotMemoryBytes) return sNOMEMORY;
  *base = t_current.object->memory().NewPrivateRegion(size);
  return *base == nullptr ? sNOMEMORY : sSUCCESS;
}

sError DeleteRegion(void* base) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  ObjectMemory& memory = t_current.object->memory();
  if (memory.DeletePrivateRegion(base)) return sSUCCESS;
  // Adds a finding, because programs seldom check the error (as DeleteSharedMemory() does).
  if (memory.WasPrivateRegionDeleted(base)) {
    t_current.system->AddFinding(
        Severity::kWarning, fmt::format("{}a region of NewRegion() is deleted that was deleted "
                                        "before{}",
                                        InHandler(), AtCaller()));
  }
  return sINVALIDARG;
}

sError NewSharedMemoryRegion(size_t size, MemoryProtectionInfo info, MemoryRegionID* id,
                             void** base) {
  const ApiScope scope;
  if (t_current.object == nullptr || id == nullptr || base == nullptr) return sINVALIDARG;
  if (info != MEMPROTINFO_R && info != MEMPROTINFO_RW) return sINVALIDSHAREDMEMPROTECT;
  *base = NewSharedMemory(size, id);
  return *base == nullptr ? sNOMEMORY : sSUCCESS;
}

sError DeleteSharedMemoryRegion(MemoryRegionID id) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  return DeleteSharedMemory(id) ? sSUCCESS : sINVALIDSHAREDMEMID;
}

sError AllowToAttachMemoryRegion(MemoryRegionID id, MemoryProtectionInfo info, OID oid,
                                 bool givingOwnership) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  const ObjectId other = ObjectIdOf(oid);
  if (t_current.system->object(other) == nullptr) return sINVALIDOID;
  return t_current.system->calls().AllowAccess(id, info, other, givingOwnership);
}

sError AttachMemoryRegion(MemoryRegionID id, MemoryProtectionInfo info, void** base) {
  const ApiScope scope;
  if (t_current.object == nullptr || base == nullptr) return sINVALIDARG;
  const sError error = t_current.system->calls().Attach(id, info);
  *base = error == sSUCCESS || error == sALREADYATTACHEDSHAREDMEM
              ? t_current.system->regions().BaseOf(id)
              : nullptr;
  if (error == sSUCCESS && *base == nullptr) {
    t_current.system->AddFinding(
        Severity::kError, fmt::format("AttachMemoryRegion({:#x}): the memory is in another process "
                                      "of a distributed run; place both objects in one",
                                      id));
    return sINVALIDSHAREDMEMID;
  }
  return error;
}

sError DetachMemoryRegion(MemoryRegionID id) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  return t_current.system->calls().Detach(id);
}

sError ChangeProtectionMemoryRegion(MemoryRegionID id, MemoryProtectionInfo info) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  return t_current.system->calls().CheckAccess(id, info);
}

sError GrowMemoryRegion(MemoryRegionID id, size_t size) { return Resize(id, size, true); }
sError ShrinkMemoryRegion(MemoryRegionID id, size_t size) { return Resize(id, size, false); }

sError GetPageSize(size_t* size) {
  if (size == nullptr) return sINVALIDARG;
  *size = kPageBytes;
  return sSUCCESS;
}

// Sets `*size` to the robot's memory minus the heaps of its objects.
sError GetFreeMemorySize(size_t* size) {
  if (t_current.object == nullptr || size == nullptr) return sINVALIDARG;
  const size_t used = t_current.system->robot(t_current.object->robot).memory.used_bytes;
  *size = used > kRobotMemoryBytes ? 0 : kRobotMemoryBytes - used;
  return sSUCCESS;
}

}  // extern "C"
