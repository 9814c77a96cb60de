// Memory that a program and the network stack share; every send and receive has to lie in
// such a buffer.
#ifndef OPENR_ANTSHAREDBUFFERDEF_H_INCLUDED
#define OPENR_ANTSHAREDBUFFERDEF_H_INCLUDED

#include <MemoryRegion.h>
#include <antTypes.h>

// 16 bytes on the robot.  A copy is another name for the same memory.
//
// The stack makes it (antEnvCreateSharedBufferMsg); then Map(), use, UnMap(), and
// antEnvDestroySharedBufferMsg.  Sizes are rounded up to pages of 4096 bytes.
class antSharedBuffer {
 public:
  antSharedBuffer() : region_(0), base_(0), size_(0), cookie_(0) {}

  // For the stack: names a buffer that exists.
  antSharedBuffer(MemoryRegionID region, uint32 size, uint32 cookie)
      : region_(region), base_(0), size_(size), cookie_(cookie) {}
  MemoryRegionID GetRegion() const { return region_; }
  uint32 GetCookie() const { return cookie_; }

  // Makes the buffer visible to this object.  REQUIRED before GetAddress().
  antError Map();
  antError UnMap();

  // First byte of the buffer, NULL while it is not mapped.
  void* GetAddress();
  uint32 GetSize() const { return size_; }

 private:
  MemoryRegionID region_;
  void* base_;     // set by Map()
  uint32 size_;    // bytes
  uint32 cookie_;  // the stack's own mark
};

#endif  // OPENR_ANTSHAREDBUFFERDEF_H_INCLUDED
