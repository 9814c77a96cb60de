// Names and access rights of shared memory regions (NewSharedMemoryRegion and its kin).
#ifndef OPENR_MEMORYREGION_H_INCLUDED
#define OPENR_MEMORYREGION_H_INCLUDED

#include <Types.h>

// As wide as a longword: programs cast a MemoryRegionID* to ODesignDataID*.
typedef unsigned int MemoryRegionID;
typedef MemoryRegionID SharedMemoryRegionID;

enum MemoryProtectionInfo {
  MEMPROTINFO_INVALID = 0,
  MEMPROTINFO_R = 1,  // read only
  MEMPROTINFO_RW = 2  // read and write
};

#endif  // OPENR_MEMORYREGION_H_INCLUDED
