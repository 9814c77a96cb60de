// A place in shared memory: a region and an offset in it.  This is an old interface; new programs
// use an RCRegion, which has the same fields and a count of references.
#ifndef OPENR_OMEMORYLOCATOR_H_INCLUDED
#define OPENR_OMEMORYLOCATOR_H_INCLUDED

#include <MCOOP.h>
#include <OPENR/StandardNames.h>
#include <Types.h>

struct OMemoryLocator {
  MemoryRegionID mid;  // 0xffffffff: an invalid place (our choice, no source gives the value)
  u_int offset;        // in bytes

  OMemoryLocator() : mid(0xffffffff), offset(0) {}
  OMemoryLocator(MemoryRegionID id, u_int off) : mid(id), offset(off) {}

  void Set(MemoryRegionID id, u_int off) {
    mid = id;
    offset = off;
  }
  bool IsInvalid() const { return mid == 0xffffffff; }
  void MakeInvalid() { Set(0xffffffff, 0); }

  bool operator==(const OMemoryLocator& other) const {
    return mid == other.mid && offset == other.offset;
  }
  // Compares two places in shared memory, by region and then by offset.
  bool operator<(const OMemoryLocator& other) const {
    return mid != other.mid ? mid < other.mid : offset < other.offset;
  }
};

// Writes a text such as "(mid:3,offset:192)".
ostream& operator<<(ostream& out, const OMemoryLocator& locator);

#endif  // OPENR_OMEMORYLOCATOR_H_INCLUDED
