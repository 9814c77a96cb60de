// NewSharedMemory(): makes shared memory for the object that calls a function of the SDK.
#pragma once

#include <MemoryRegion.h>
#include <fmt/format.h>

#include "runtime/base/assert.h"
#include "runtime/core/code_place.h"
#include "runtime/core/system.h"

namespace openr_host {

// Makes a region of shared memory, owned by the current object, and returns the region's address.
// If there is no memory left, or `bytes` is more than the memory of the robot, returns null and
// sets `*id` to 0.
inline char* NewSharedMemory(size_t bytes, MemoryRegionID* id) {
  ASSERT(t_current.object != nullptr && id != nullptr);
  *id = RegionTable::kNoRegion;
  if (bytes > kRobotMemoryBytes) return nullptr;
  *id = t_current.system->calls().NewRegion(bytes, t_current.object->id);
  RegionTable& regions = t_current.system->regions();
  if (t_current.system->options().find_leaks) regions.NotePlace(*id, CallerInImage());
  return regions.BaseOf(*id);
}

// Deletes the region `id` for the current object.  Returns false if there is no such region.  If
// this region was deleted before, also adds a finding, because on the robot programs only get an
// error, which they seldom check.
inline bool DeleteSharedMemory(MemoryRegionID id) {
  if (t_current.system->calls().DeleteRegion(id)) return true;
  if (t_current.system->regions().WasDeleted(id))
    t_current.system->AddFinding(Severity::kWarning,
                                 fmt::format("{}region {:#x} is deleted that was deleted before{}",
                                             InHandler(), id, AtCaller()));
  return false;
}

}  // namespace openr_host
