// The header under which some sources look for MemoryRegionID; the types are in Types.h.
#ifndef OPENR_MEMORYREGION_H_INCLUDED
#define OPENR_MEMORYREGION_H_INCLUDED

#include <Types.h>

#endif  // OPENR_MEMORYREGION_H_INCLUDED
