// RCRegion, a piece of shared memory with a count of references.
//
// A program makes an RCRegion with new and releases it with RemoveReference(); an RCRegion deletes
// itself when its count reaches 0.  Subject and observer each have an RCRegion of their own for the
// same memory, each with a count of its own.
//
// A subject that sends an RCRegion adds a reference to its own RCRegion for each observer, and
// removes the reference when the observer gives the memory back with its next ready.  So a count of
// 1 in the subject's RCRegion means that no observer uses the memory, and the program may write to
// it.
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
    SELF_ALLOCATED,  // made by RCRegion(size); owns its memory
    REFERENCE_V20,   // refers to memory that another RCRegion or the program has made
    REFERENCE_V10,
    UNDEF
  };

  // Makes an empty region with 0 references; call AddReference() before use.
  RCRegion();

  // Makes an RCRegion with 1 reference and allocates its memory: `size` bytes, filled with zeros.
  // Base() is 0 if the memory cannot be allocated.
  explicit RCRegion(size_t size);

  // Makes an RCRegion with 1 reference for existing memory, which it does not own.  If baseAddr is
  // 0, the address is looked up by id.
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
  RCRegion* source_;  // in an observer's RCRegion: the subject's RCRegion; else 0
};

typedef RCRegion RCRegionBase;

#endif  // OPENR_RCREGION_H_INCLUDED
