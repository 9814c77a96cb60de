#include "runtime/core/arena.h"

#include <sys/mman.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/current.h"

namespace openr_host {
namespace {

// Size in bytes of the largest block that shares a span (a piece of 64 KiB of the heap) with other
// blocks.  A larger block gets whole spans.
constexpr size_t kLargest = 32 << 10;
constexpr size_t kMapBytes = 1 << 20;  // memory is mapped in steps of this size

// The arena (heap) of each object.  The index is the number of the object's place (address_plan.h).
constinit Arena* g_arenas[ObjectAddresses::kPlaces] = {};

// Returns the size of the blocks of a size class: 16, 32, 48 ... 256 bytes for classes 0 to 15.
// The later classes go up to 32 KiB, with four classes between each power of two and the next.
size_t SizeOfClass(int size_class) {
  if (size_class < 16) return static_cast<size_t>(size_class + 1) * 16;
  const int step = size_class - 16;
  const size_t base = size_t{256} << (step / 4);
  return base + base / 4 * static_cast<size_t>(step % 4 + 1);
}

int ClassOfSize(size_t size) {
  if (size <= 256) return size == 0 ? 0 : static_cast<int>((size - 1) / 16);
  // The range of `size` above 256: 0 for 257 to 512, 1 for 513 to 1024, and so on.
  const int doubling = std::bit_width(size - 1) - 9;
  const size_t base = size_t{256} << doubling;
  return 16 + doubling * 4 + static_cast<int>((size - 1 - base) / (base / 4));
}

}  // namespace

Arena::Arena(const ObjectAddresses& place, MemoryBudget* budget)
    : base_(place.heap()), budget_(budget == nullptr ? &own_budget_ : budget) {
  ASSERT(base_ != nullptr && OwnerOf(base_) == nullptr, "a place has one heap");
  g_arenas[ObjectAddresses::OfHeap(base_)] = this;
}

Arena::~Arena() {
  ASSERT(budget_->used_bytes >= in_use_, "the robot's objects use {} bytes, this one {}",
         budget_->used_bytes, in_use_);
  budget_->used_bytes -= in_use_;
  g_arenas[ObjectAddresses::OfHeap(base_)] = nullptr;
  if (mapped_spans_ > 0) munmap(base_, mapped_spans_ * kSpanBytes);
}

bool Arena::MapUpTo(size_t span_end) {
  if (span_end <= mapped_spans_) return true;
  constexpr size_t kStep = kMapBytes / kSpanBytes;
  // Rounds the number of mapped spans (pieces of 64 KiB) up to a multiple of kStep, because memory
  // is mapped in steps of 1 MiB.  The spans up to `end` still lie in the object's heap area,
  // because the size of that area is a multiple of 1 MiB.
  const size_t end = (span_end + kStep - 1) / kStep * kStep;
  {
    const ApiScope scope;  // makes the lists take memory of the host's heap
    spans_.resize(end);
    begins_.resize(end * kSpanBytes / 16);
  }
  if (!MapAt(base_ + mapped_spans_ * kSpanBytes, (end - mapped_spans_) * kSpanBytes)) return false;
  mapped_spans_ = end;
  return true;
}

// Allocates `count` neighbouring free spans (pieces of 64 KiB) with the lowest addresses, and
// returns the first address.  `use` becomes the Span::use of the first span: a size class, or
// kLarge.  The bytes of the spans are zeros.  Returns null if there are not enough neighbouring
// free spans, or no memory.
char* Arena::AllocateSpans(size_t count, int16_t use) {
  size_t run = 0;
  for (size_t i = first_free_; i < kSpans; ++i) {
    run = SpanAt(i).use == kFree ? run + 1 : 0;
    if (run < count) continue;
    const size_t first = i + 1 - count;
    if (!MapUpTo(i + 1)) return nullptr;
    for (size_t k = first; k <= i; ++k) spans_[k].use = kInside;
    spans_[first] = {use, static_cast<uint16_t>(count)};
    if (first == first_free_) first_free_ = i + 1;
    return base_ + first * kSpanBytes;
  }
  return nullptr;
}

// Frees the spans (pieces of 64 KiB) of the large block that begins with span number `first`.
void Arena::FreeSpans(size_t first) {
  const size_t count = spans_[first].span_count;
  // Gives the pages of the freed spans back to the kernel (MADV_DONTNEED), which gives pages of
  // zeros at the next access.  So free spans hold only zeros, which AllocateSpans() promises.
  madvise(base_ + first * kSpanBytes, count * kSpanBytes, MADV_DONTNEED);
  for (size_t k = first; k < first + count; ++k) spans_[k] = {};
  first_free_ = std::min(first_free_, first);
}

void Arena::LeaveBudget() {
  budget_->used_bytes -= in_use_;
  own_budget_.used_bytes = in_use_;
  budget_ = &own_budget_;
}

bool Arena::MayTake(size_t size) {
  if (budget_->allocations_until_failure > 0 && --budget_->allocations_until_failure == 0)
    return false;
  return size <= budget_->limit_bytes && budget_->used_bytes <= budget_->limit_bytes - size;
}

void Arena::Account(size_t size) {
  in_use_ += size;
  budget_->used_bytes += size;
  in_use_max_ = std::max(in_use_max_, in_use_);
}

void* Arena::Allocate(size_t size, size_t alignment) {
  // A block of a size class that is a power of two lies at a multiple of its size.  So for an
  // alignment above 16 bytes, rounds `size` up to a power of two that is at least `alignment`.
  if (alignment > 16) size = std::bit_ceil(std::max(size, alignment));
  if (!MayTake(size)) return nullptr;
  if (alignment > kSpanBytes) return nullptr;
  void* const block = size <= kLargest ? AllocateSmall(ClassOfSize(size)) : AllocateLarge(size);
  if (block != nullptr) begins_[PlaceOf(block)] = true;
  return block;
}

void* Arena::AllocateSmall(int size_class) {
  const size_t size = SizeOfClass(size_class);
  void* block = free_[size_class];
  if (block != nullptr) {
    free_[size_class] = free_[size_class]->next;
    std::memset(block, 0, size);
  } else {
    if (bump_[size_class] == nullptr || bump_[size_class] + size > bump_end_[size_class]) {
      char* const span = AllocateSpans(1, static_cast<int16_t>(size_class));
      if (span == nullptr) return nullptr;
      bump_[size_class] = span;
      bump_end_[size_class] = span + kSpanBytes;
    }
    block = bump_[size_class];
    bump_[size_class] += size;
  }
  Account(size);
  return block;
}

void* Arena::AllocateLarge(size_t size) {
  const size_t count = (size + kSpanBytes - 1) / kSpanBytes;
  if (count > kSpans) return nullptr;
  void* const block = AllocateSpans(count, kLarge);
  if (block != nullptr) Account(count * kSpanBytes);
  return block;
}

Arena* Arena::OwnerOf(const void* block) {
  const int place = ObjectAddresses::OfHeap(block);
  return place < 0 ? nullptr : g_arenas[place];
}

size_t Arena::SizeOf(const void* block) const {
  const Span& span = SpanAt(IndexOf(block));
  return span.use >= 0 ? SizeOfClass(span.use) : span.span_count * kSpanBytes;
}

size_t Arena::UsableSize(const void* block) { return OwnerOf(block)->SizeOf(block); }

bool Arena::Free(void* block) { return OwnerOf(block)->FreeFrom(block); }

void Arena::FreeAny(void* block) {
  if (OwnerOf(block) == nullptr) {
    std::free(block);
  } else {
    Free(block);
  }
}

bool Arena::IsBegin(const void* block) const {
  const size_t place = PlaceOf(block);
  return reinterpret_cast<uintptr_t>(block) % 16 == 0 && place < begins_.size() && begins_[place];
}

bool Arena::WasFreed(const void* block) {
  const Arena& arena = *OwnerOf(block);
  const Span& span = arena.SpanAt(arena.IndexOf(block));
  const auto offset =
      static_cast<size_t>(static_cast<const char*>(block) - arena.base_) % kSpanBytes;
  if (span.use < 0) return span.use == kFree && offset == 0;
  // `unused` is the first block of the size class that was never allocated.  It lies in the newest
  // span (piece of 64 KiB) of the class.  The blocks behind it were never allocated either, so no
  // block from `unused` on was freed.
  const char* const unused = arena.bump_[span.use];
  const bool is_of_newest_span =
      unused != nullptr && arena.IndexOf(unused - 1) == arena.IndexOf(block);
  return offset % SizeOfClass(span.use) == 0 && !(is_of_newest_span && block >= unused);
}

void Arena::NoteCalls(const void* block, Calls calls) {
  (*calls_)[static_cast<uint32_t>(PlaceOf(block))] = std::move(calls);
}

void Arena::ForEachBlock(const std::function<void(char*, size_t, const Calls&)>& visit) const {
  if (calls_ == nullptr) return;
  for (const auto& [place, calls] : *calls_) {
    char* const block = base_ + size_t{place} * 16;
    visit(block, SizeOf(block), calls);
  }
}

bool Arena::FreeFrom(void* block) {
  if (!IsBegin(block)) return false;
  begins_[PlaceOf(block)] = false;
  if (calls_ != nullptr) calls_->erase(static_cast<uint32_t>(PlaceOf(block)));
  const size_t index = IndexOf(block);
  const int16_t use = spans_[index].use;
  const size_t size = SizeOf(block);
  ASSERT(size <= in_use_, "a block of {} bytes is freed, {} are in use", size, in_use_);
  in_use_ -= size;
  budget_->used_bytes -= size;
  if (use == kLarge) {
    FreeSpans(index);
    return true;
  }
  FreeBlock* const free_block = static_cast<FreeBlock*>(block);
  free_block->next = free_[use];
  free_[use] = free_block;
  return true;
}

}  // namespace openr_host
