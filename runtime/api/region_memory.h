// NewSharedMemory(): makes shared memory for the object that calls a function of the SDK.
#pragma once

#include <MemoryRegion.h>

#include "runtime/base/assert.h"
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
  return t_current.system->regions().BaseOf(*id);
}

}  // namespace openr_host
