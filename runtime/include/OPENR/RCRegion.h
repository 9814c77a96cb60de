// RCRegion: a piece of shared memory with a reference count.
//
// Always made with new and given back with RemoveReference(); the instance
// destroys itself when the count reaches 0.  Subject and observer each have an
// RCRegion of their own for the same memory, each with its own count.
//
// In the subject's object: 1 = only the owner refers, the memory may be
// written; more = still on its way to that many observers.
#ifndef OPENR_RCREGION_H_INCLUDED
#define OPENR_RCREGION_H_INCLUDED

#include <OPENR/OMemoryLocator.h>
#include <OPENR/SharedMemoryHeader.h>
#include <Types.h>
#include <stddef.h>

typedef unsigned int offset_t;

namespace openr_host {
struct RegionAccess;
}

class RCRegion {
 public:
  enum RegionType {
    SELF_ALLOCATED,  // made by RCRegion(size), which owns the memory
    REFERENCE_V20,   // refers to memory made by somebody else
    REFERENCE_V10,
    UNDEF
  };

  // Empty, count 0: AddReference() before use.
  RCRegion();

  // Fresh zero-filled memory of `size` bytes, count 1.  Base() is 0 when
  // there is no memory.
  explicit RCRegion(size_t size);

  // Refers to existing memory without owning it, count 1.  With baseAddr 0
  // the address is looked up by id.
  RCRegion(MemoryRegionID id, offset_t offset, void* baseAddr = 0, size_t size = 0);

  void AddReference();
  void RemoveReference();
  int NumberOfReference() const { return count_; }

  char* Base() const { return base_; }
  size_t Size() const { return size_; }
  MemoryRegionID MemID() const { return id_; }
  offset_t Offset() const { return offset_; }
  void SetSize(size_t size) { size_ = size; }
  RegionType GetType() const { return type_; }

  static void* operator new(size_t size);
  static void operator delete(void* memory);

 private:
  friend struct openr_host::RegionAccess;

  ~RCRegion();
  RCRegion(const RCRegion&);
  RCRegion& operator=(const RCRegion&);

  char* base_;
  size_t size_;
  int count_;
  MemoryRegionID id_;
  offset_t offset_;
  RegionType type_;
  RCRegion* source_;  // the subject's region this one stands for; 0 when it is not a received one
};

typedef RCRegion RCRegionBase;

#endif  // OPENR_RCREGION_H_INCLUDED
