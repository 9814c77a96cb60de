// A block at the start of shared memory that says where it lies.
#ifndef OPENR_SHAREDMEMORYHEADER_H_INCLUDED
#define OPENR_SHAREDMEMORYHEADER_H_INCLUDED

#include <Types.h>

// 16 bytes on the robot, where ODataVectorInfo begins with the same four fields.
struct SharedMemoryHeader {
  MemoryRegionID memID;
  void* physAddr;
  unsigned int offset;     // in the region, bytes
  unsigned int totalSize;  // bytes
};
typedef SharedMemoryHeader ShmHdr;

#endif  // OPENR_SHAREDMEMORYHEADER_H_INCLUDED
