// Memory that a program and the network stack share.  The data of every send and receive must be in
// such a buffer.
#ifndef OPENR_ANTSHAREDBUFFERDEF_H_INCLUDED
#define OPENR_ANTSHAREDBUFFERDEF_H_INCLUDED

#include <MemoryRegion.h>
#include <antTypes.h>

// A reference to a buffer that a program shares with the network stack.  An antSharedBuffer has 16
// bytes on the robot; the size of the buffer is a multiple of 4096 bytes.  A copy of an
// antSharedBuffer refers to the same buffer.
//
// The network stack makes the buffer (antEnvCreateSharedBufferMsg).  The program calls Map(), uses
// the buffer, calls UnMap() and sends antEnvDestroySharedBufferMsg.
class antSharedBuffer {
 public:
  antSharedBuffer() : region_(0), base_(0), size_(0), cookie_(0) {}

  // Makes a reference to an existing shared buffer; used by the network stack.
  antSharedBuffer(MemoryRegionID region, uint32 size, uint32 cookie)
      : region_(region), base_(0), size_(size), cookie_(cookie) {}
  MemoryRegionID GetRegion() const { return region_; }
  uint32 GetCookie() const { return cookie_; }

  // Maps this shared buffer into the memory of the calling object; required before GetAddress().
  antError Map();
  antError UnMap();

  // Returns the address of the first byte of this shared buffer; NULL while the buffer is not
  // mapped.
  void* GetAddress();
  uint32 GetSize() const { return size_; }

 private:
  MemoryRegionID region_;
  void* base_;     // set by Map()
  uint32 size_;    // in bytes
  uint32 cookie_;  // the number that the network stack has given to the buffer
};

#endif  // OPENR_ANTSHAREDBUFFERDEF_H_INCLUDED
