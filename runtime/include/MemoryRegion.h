// Some sources include this header for the type MemoryRegionID, which is in Types.h.
#ifndef OPENR_MEMORYREGION_H_INCLUDED
#define OPENR_MEMORYREGION_H_INCLUDED

#include <Types.h>

#endif  // OPENR_MEMORYREGION_H_INCLUDED
