#include "runtime/core/object_memory.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "runtime/base/assert.h"

namespace openr_host {

void ObjectMemory::Plan(std::unique_ptr<ObjectAddresses> addresses, MemoryBudget* budget) {
  ASSERT(addresses_ == nullptr && addresses != nullptr, "an object gets its addresses once");
  addresses_ = std::move(addresses);
  arena_ = std::make_unique<Arena>(*addresses_, budget);
}

void* ObjectMemory::NewPrivateRegion(size_t size) {
  void* const base =
      arena_ == nullptr ? std::calloc(1, std::max<size_t>(size, 1)) : arena_->Allocate(size);
  if (base == nullptr) return nullptr;
  private_regions_.insert(base);
  deleted_regions_.erase(~reinterpret_cast<uintptr_t>(base));
  return base;
}

bool ObjectMemory::DeletePrivateRegion(void* base) {
  if (private_regions_.erase(base) == 0) return false;
  deleted_regions_.insert(~reinterpret_cast<uintptr_t>(base));
  Arena::FreeAny(base);
  return true;
}

void ObjectMemory::DeletePrivateRegions() {
  for (void* const region : private_regions_) Arena::FreeAny(region);
  private_regions_.clear();
}

}  // namespace openr_host
