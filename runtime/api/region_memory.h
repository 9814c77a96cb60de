// Shared memory that an SDK function makes for the object that calls it.
#pragma once

#include <MemoryRegion.h>

#include "runtime/core/system.h"

namespace openr_host {

// Null, and `*id` 0, when there is no memory.  No piece can be larger than the robot's.
inline char* NewSharedMemory(size_t bytes, MemoryRegionID* id) {
  *id = RegionTable::kNoRegion;
  if (bytes > kRobotMemoryBytes) return nullptr;
  *id = t_current.system->calls().NewRegion(bytes, t_current.object->id);
  return t_current.system->regions().BaseOf(*id);
}

}  // namespace openr_host
