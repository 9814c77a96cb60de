// The header at the start of shared memory.  It has the memory's id, physical address, offset in
// its region and size.
#ifndef OPENR_SHAREDMEMORYHEADER_H_INCLUDED
#define OPENR_SHAREDMEMORYHEADER_H_INCLUDED

#include <Types.h>

// The header at the start of shared memory, 16 bytes on the robot.  On the robot, an
// ODataVectorInfo begins with the same four fields.  On a 64-bit host the two structs differ,
// because the pointer physAddr of this header has 64 bits.
struct SharedMemoryHeader {
  MemoryRegionID memID;
  void* physAddr;
  unsigned int offset;     // offset of this memory in bytes from the start of its region
  unsigned int totalSize;  // in bytes
};
typedef SharedMemoryHeader ShmHdr;

#endif  // OPENR_SHAREDMEMORYHEADER_H_INCLUDED
