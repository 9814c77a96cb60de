#include "runtime/core/region_access.h"

#include "runtime/core/guard_pages.h"
#include "runtime/core/rcregion_pool.h"
#include "runtime/core/system.h"

namespace openr_host {

RCRegion* RegionAccess::Receive(System* system, const TransferedData& data) {
  RCRegion* const region = new RCRegion(data.memID, data.offset, data.srcRCR->base_, data.size);
  region->source_ = data.srcRCR;
  system->PinRegion(data.memID);
  if (system->guard_pages() != nullptr) [[unlikely]]
    UseReadOnlyCopy(region);
  return region;
}

// Makes a read-only copy of the data of `region`, an RCRegion that the current object has received,
// and replaces the address in `region` by the address of the copy.  Does nothing if the current
// object may write into the memory.
void RegionAccess::UseReadOnlyCopy(RCRegion* region) {
  System* const system = t_current.system;
  const Object* const self = t_current.object;
  if (self->is_system() || system->region_shares().MayWrite(self->id, region->id_)) return;
  char* const copy = system->guard_pages()->NewCopy(self->memory().addresses(),
                                                    region->source_->Base(), region->size_);
  if (copy != nullptr) region->base_ = copy;
}

void RegionAccess::Complete(RCRegion* region) {
  if (t_current.system == nullptr) return;
  const RegionTable& table = t_current.system->regions();
  char* const base = table.BaseOf(region->id_);
  const size_t size = table.SizeOf(region->id_);
  if (region->base_ == nullptr && base != nullptr) region->base_ = base + region->offset_;
  if (region->size_ == 0 && size > region->offset_) region->size_ = size - region->offset_;
}

void RegionAccess::GiveBack(System* system, RCRegion* received) {
  if (GuardPages* const guard = system->guard_pages()) [[unlikely]]
    guard->Retire(received->base_);
  // Does the same as `delete received`, but without the destructor's test for a received region:
  // the caller knows that `received` is one.
  system->UnpinRegion(received->id_);
  RCRegionPool::Give(received);
}

}  // namespace openr_host
