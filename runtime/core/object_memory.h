// ObjectMemory: the memory of one object, that is, its part of the address plan (address_plan.h),
// its heap, and the memory blocks that NewRegion() (MCOOP.h) has given to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>

#include "runtime/core/address_plan.h"
#include "runtime/core/arena.h"

namespace openr_host {

class ObjectMemory {
 public:
  // Gives the object its part of the address plan and a heap there.  `budget` counts the bytes of
  // the heap, and must outlive the heap.  REQUIRES: called once.
  void Plan(std::unique_ptr<ObjectAddresses> addresses, MemoryBudget* budget);

  // Returns the object's part of the address plan.  Null for objects that are no images, and where
  // addresses are not planned.
  ObjectAddresses* addresses() const { return addresses_.get(); }
  // Returns the heap of the object, at its addresses.  Null if addresses() is null.
  Arena* arena() const { return arena_.get(); }

  // Takes `size` bytes for NewRegion(): from the heap, where addresses are the same in every run,
  // or from the host's heap if there is no heap at planned addresses.  Returns null if there is no
  // memory.
  void* NewPrivateRegion(size_t size);
  // Frees memory that NewPrivateRegion() has returned.  Returns false if `base` is no such memory.
  bool DeletePrivateRegion(void* base);
  // Returns whether a region at `base` was deleted, and no region was made there since.
  bool WasPrivateRegionDeleted(const void* base) const {
    return deleted_regions_.contains(~reinterpret_cast<uintptr_t>(base));
  }
  // Frees all memory of NewPrivateRegion() that is not freed yet.
  void DeletePrivateRegions();
  // Nothing may depend on the order of the set, because addresses differ from run to run.
  const std::set<void*>& private_regions() const { return private_regions_; }

 private:
  std::set<void*> private_regions_;
  // The addresses of deleted regions, with all bits inverted, so that the search for leaks does not
  // take them for pointers to blocks of the object.
  std::set<uintptr_t> deleted_regions_;
  std::unique_ptr<ObjectAddresses> addresses_;
  std::unique_ptr<Arena> arena_;
};

}  // namespace openr_host
