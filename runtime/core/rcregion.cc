#include <OPENR/RCRegion.h>
#include <fmt/format.h>

#include <cstddef>
#include <new>
#include <set>
#include <string>
#include <vector>

#include "runtime/base/assert.h"
#include "runtime/core/code_place.h"
#include "runtime/core/connection_state.h"
#include "runtime/core/guard_pages.h"
#include "runtime/core/imported_calls.h"
#include "runtime/core/system.h"

using openr_host::ApiScope;
using openr_host::kNoObject;
using openr_host::RegionTable;
using openr_host::t_current;

namespace {

// The number of RCRegions for which the pool takes memory from the host's heap at a time.
// RCRegions are small, many and short-lived, so single allocations would take long.  The pool is
// never deleted, because a static object of the program may still delete regions when the program
// ends.
constexpr size_t kChunk = 64;

// The memory of one RCRegion in the pool.  The link to the next free block lies behind the
// RCRegion, because a program may by mistake read a region that it has given back, and must then
// find the old content, as on the robot.
struct Block {
  alignas(RCRegion) std::byte region[sizeof(RCRegion)];
  Block* next;
};
static_assert(offsetof(Block, region) == 0);
thread_local constinit Block* t_free = nullptr;  // the first free block of the pool
// The addresses of all chunks, the arrays of memory for RCRegions.  With this list, a leak checker
// finds that the chunks are reachable.  Otherwise it would report a chunk when an object has not
// deleted its regions.
thread_local constinit std::vector<Block*>* t_chunks = nullptr;

void GiveToPool(void* memory) {
  Block* const block = static_cast<Block*>(memory);
  block->next = t_free;
  t_free = block;
}

void AddChunk() {
  const ApiScope scope;
  if (t_chunks == nullptr) t_chunks = new std::vector<Block*>;
  auto* const chunk = static_cast<Block*>(::operator new(sizeof(Block) * kChunk));
  t_chunks->push_back(chunk);
  for (size_t i = kChunk; i > 0; --i) GiveToPool(chunk + i - 1);
}

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
  if (t_free == nullptr) AddChunk();
  Block* const block = t_free;
  t_free = block->next;
  return block;
}

void RCRegion::operator delete(void* memory) {
  if (memory != nullptr) GiveToPool(memory);
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
  // holds one reference to a received region until the observer's next ready gives the region back.
  // So if no reference is left here, the object has removed one too many.  The RCRegion is not
  // deleted then, because the runtime still uses it.
  const bool received = source_ != nullptr;
  if ((received || count_ < 0) && t_current.system != nullptr) {
    t_current.system->AddFinding(
        openr_host::Severity::kError,
        "RemoveReference() on a region to which this object holds no reference");
    return;
  }
  delete this;
}

namespace openr_host {

void RegionAccess::VisitPool(const std::function<void(const void*, size_t)>& memory,
                             const std::function<void(const RCRegion*)>& used) {
  if (t_chunks == nullptr) return;
  std::set<const Block*> free;
  for (const Block* block = t_free; block != nullptr; block = block->next) free.insert(block);
  memory(t_chunks->data(), t_chunks->capacity() * sizeof(Block*));
  for (const Block* const chunk : *t_chunks) {
    memory(chunk, sizeof(Block) * kChunk);
    for (size_t i = 0; i < kChunk; ++i) {
      if (!free.contains(chunk + i)) used(reinterpret_cast<const RCRegion*>(chunk + i));
    }
  }
}

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
  const RegionTable* const table = Table();
  if (table == nullptr) return;
  char* const base = table->BaseOf(region->id_);
  const size_t size = table->SizeOf(region->id_);
  if (region->base_ == nullptr && base != nullptr) region->base_ = base + region->offset_;
  if (region->size_ == 0 && size > region->offset_) region->size_ = size - region->offset_;
}

void RegionAccess::GiveBack(System* system, RCRegion* received) {
  if (GuardPages* const guard = system->guard_pages()) [[unlikely]]
    guard->Retire(received->base_);
  // Does the same as `delete received`, but without the destructor's test whether the region is a
  // received region, because the caller knows that it is.
  system->UnpinRegion(received->id_);
  GiveToPool(received);
}

}  // namespace openr_host
