#include <OPENR/RCRegion.h>
#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "runtime/base/assert.h"
#include "runtime/core/code_place.h"
#include "runtime/core/imported_calls.h"
#include "runtime/core/rcregion_pool.h"
#include "runtime/core/region_access.h"
#include "runtime/core/system.h"

using openr_host::ApiScope;
using openr_host::kNoObject;
using openr_host::RegionTable;
using openr_host::t_current;

namespace {

// Returns a text about the place in the program that made the most regions: ", 65000 of them made
// at Talker.cc:57".  Returns "" if that place is not known.
std::string OriginText(const RegionTable& table) {
  const auto [address, count] = table.MostCommonPlace();
  const std::string place = openr_host::NameOfPlace(address);
  return place.empty() ? "" : fmt::format(", {} of them made at {}", count, place);
}

RegionTable* Table() {
  return t_current.system == nullptr ? nullptr : &t_current.system->regions();
}

}  // namespace

void* RCRegion::operator new(size_t size) {
  ASSERT(size == sizeof(RCRegion), "RCRegion is not a base class");
  return openr_host::RCRegionPool::Take();
}

void RCRegion::operator delete(void* memory) {
  if (memory != nullptr) openr_host::RCRegionPool::Give(memory);
}

RCRegion::RCRegion()
    : base_(nullptr),
      size_(0),
      count_(0),
      id_(RegionTable::kNoRegion),
      offset_(0),
      type_(UNDEF),
      source_(nullptr) {}

RCRegion::RCRegion(size_t size)
    : base_(nullptr),
      size_(size),
      count_(1),
      id_(RegionTable::kNoRegion),
      offset_(0),
      type_(SELF_ALLOCATED),
      source_(nullptr) {
  const bool is_by_image = t_current.image_code;
  const ApiScope scope;
  RegionTable* const table = Table();
  ASSERT(table != nullptr, "new RCRegion outside of an object");
  // The calls of a worker process refuse such a size too, but would not say why.
  if (size > openr_host::kRobotMemoryBytes) {
    t_current.system->AddFinding(
        openr_host::Severity::kError,
        fmt::format("{}no shared memory for {} bytes{}: a region has at most {} MiB, the memory of "
                    "the robot",
                    openr_host::InHandler(), size, openr_host::AtCaller(),
                    openr_host::kRobotMemoryBytes >> 20));
    return;
  }
  id_ = t_current.system->calls().NewRegion(
      size, t_current.object == nullptr ? kNoObject : t_current.object->id);
  if (is_by_image) {
    const void* const caller = openr_host::ReturnAddressInImage(__builtin_return_address(0));
    // Subtracts 1 from `caller`, the return address, so that the address lies in the call that
    // makes the region and names its source line.
    table->NotePlace(id_, static_cast<const char*>(caller) - 1);
  }
  base_ = table->BaseOf(id_);
  if (base_ == nullptr) {
    t_current.system->AddFinding(
        openr_host::Severity::kError,
        fmt::format(
            "no shared memory for {} bytes: {} regions are alive{}; a region made for every "
            "message has to be given up with RemoveReference()",
            size, table->live_count(), OriginText(*table)));
  }
}

RCRegion::RCRegion(MemoryRegionID id, offset_t offset, void* base, size_t size)
    : base_(static_cast<char*>(base)),
      size_(size),
      count_(1),
      id_(id),
      offset_(offset),
      type_(REFERENCE_V20),
      source_(nullptr) {
  if (base_ == nullptr || size_ == 0) [[unlikely]]
    openr_host::RegionAccess::Complete(this);
}

RCRegion::~RCRegion() {
  if (t_current.system == nullptr) return;
  if (type_ == SELF_ALLOCATED) {
    t_current.system->calls().DeleteRegion(id_);
  } else if (source_ != nullptr) {
    t_current.system->UnpinRegion(id_);
  }
}

void RCRegion::AddReference() { ++count_; }

// Removes one reference.  Deletes the RCRegion if no reference is left.  Too many calls are a
// mistake of the object, so they become a finding and not a failed assertion.
void RCRegion::RemoveReference() {
  if (--count_ > 0) return;
  const ApiScope scope;
  // A received region is an RCRegion with a source_, the RCRegion of the subject.  The runtime
  // itself holds one reference to it until the observer's next ready gives the region back.  So if
  // no reference is left here, the object has removed the runtime's reference.  The RCRegion is not
  // deleted, because the runtime still uses it.
  const bool received = source_ != nullptr;
  if ((received || count_ < 0) && t_current.system != nullptr) {
    t_current.system->AddFinding(
        openr_host::Severity::kError,
        "RemoveReference() on a region to which this object holds no reference");
    return;
  }
  delete this;
}
