// The heap of one object: freed as a whole when the object goes.
//
// Memory comes in spans of 64 KiB out of the addresses that are planned for the object
// (address_plan.h), so that any address tells in O(1) whose it is; free() works from anywhere.
// Small blocks live in size classes with free lists, large ones get spans of their own.
// Every block is zero when it is handed out: what an earlier block left there may be
// an address of the C library, which no run may depend on.
// What an object may take is bounded by the memory of its robot, which all its objects
// share (the .ocf heap size is a step of growth, no limit), and by the addresses of its place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/core/address_plan.h"

namespace openr_host {

// The memory of one robot.
struct MemoryBudget {
  size_t limit_bytes = SIZE_MAX;
  size_t used_bytes = 0;
  int allocations_until_failure = -1;  // for tests: 1 fails the next; < 0: never
};

class Arena {
 public:
  // Allocates in the heap area of `place`, which no other arena may use.  A null `budget` is
  // without limit; otherwise it must outlive the arena.  REQUIRES: place.heap() is not null.
  explicit Arena(const AddressPlace& place, MemoryBudget* budget = nullptr);
  ~Arena();  // every block is gone afterwards
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  // A block of zeros; null when the budget or the heap area is exhausted.  Alignment is 16, or
  // `alignment` if that is larger; REQUIRES: a power of two.
  void* Allocate(size_t size, size_t alignment = 16);

  size_t bytes_in_use() const { return in_use_; }
  size_t bytes_in_use_max() const { return in_use_max_; }

  // The arena that `block` came from; null when it is not an arena's.
  static Arena* OwnerOf(const void* block);
  // REQUIRES: OwnerOf(block) is not null.
  static void Free(void* block);
  // Frees a block of an arena or of the host's heap.  For memory that was taken from an arena
  // directly: under Valgrind free() is not ours.
  static void FreeAny(void* block);
  static size_t UsableSize(const void* block);

 private:
  static constexpr int kClasses = 44;
  static constexpr size_t kSpanBytes = size_t{64} << 10;
  static constexpr size_t kSpans = AddressPlace::kHeapBytes / kSpanBytes;

  // A span belongs to small blocks of one class, or is the first one of a large block or
  // lies inside of a large block.
  struct Span {
    int16_t use = kFree;      // a size class, or one of the numbers below
    uint16_t span_count = 0;  // of a large block, in its first span
  };
  static constexpr int16_t kFree = -1, kLarge = -2, kInside = -3;

  struct FreeBlock {
    FreeBlock* next;
  };

  char* TakeSpans(size_t count, int16_t use);
  void GiveSpans(size_t first);
  bool MapUpTo(size_t span_end);
  size_t IndexOf(const void* block) const {
    return static_cast<size_t>(static_cast<const char*>(block) - base_) / kSpanBytes;
  }
  size_t SizeOf(const void* block) const;
  void* AllocateSmall(int size_class);
  void* AllocateLarge(size_t size);
  void FreeFrom(void* block);
  bool MayTake(size_t size);
  void Account(size_t size);

  char* const base_;
  std::vector<Span> spans_;
  size_t first_free_ = 0;    // no free span lies before it
  size_t mapped_spans_ = 0;  // spans up to here have memory
  FreeBlock* free_[kClasses] = {};
  char* bump_[kClasses] = {};  // next never-used block of the class
  char* bump_end_[kClasses] = {};
  size_t in_use_ = 0;
  size_t in_use_max_ = 0;
  MemoryBudget own_budget_;
  MemoryBudget* const budget_;
};

}  // namespace openr_host
