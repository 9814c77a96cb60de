// Arena: the heap of one object.  All its memory is freed when the object is destroyed.
//
// Memory comes in spans of 64 KiB from the heap area of the object's place (address_plan.h).  Small
// blocks belong to size classes with free lists; each large block has spans of its own.  The
// address of a block shows in O(1) to which arena the block belongs, so free() works whichever
// object is running.  A block is filled with zeros when it is allocated, because no run may depend
// on old content of the block, such as an address of the C library.
//
// An arena has two limits: the memory of the robot, which all its objects share, and the size of
// the place's heap area.  The heap size in the object's .ocf file is no limit, because on the robot
// the heap grows in steps of that size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "runtime/core/address_plan.h"

namespace openr_host {

// The memory that all objects of one robot use together, and the limit of this memory.
struct MemoryBudget {
  size_t limit_bytes = SIZE_MAX;
  size_t used_bytes = 0;
  // For tests: the number of allocations until an allocation fails.  With 1, the next allocation
  // fails.  With 0 or less, no allocation fails.
  int allocations_until_failure = -1;
};

class Arena {
 public:
  // Makes an empty heap in the heap area of `place` (address_plan.h), which no other arena may use.
  // `budget` is the memory that all objects of the robot share; it must outlive the arena.  If
  // `budget` is null, the size of the area is the only limit.  REQUIRES: place.heap() is not null.
  explicit Arena(const ObjectAddresses& place, MemoryBudget* budget = nullptr);
  ~Arena();  // frees all blocks
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  // Returns a block of zeros, or null if the memory of the robot or the heap area is exhausted.
  // The address of the block is a multiple of 16, or of `alignment` (rounded up to a power of two)
  // if that is larger.
  void* Allocate(size_t size, size_t alignment = 16);

  // Gives the memory of this arena back to the budget that the robot's objects share, because the
  // object of this arena was replaced.  From then on the size of the heap area is the only limit.
  void LeaveBudget();

  size_t bytes_in_use() const { return in_use_; }
  size_t bytes_in_use_max() const { return in_use_max_; }

  // Returns the arena that `block` was allocated from, or null if `block` lies in no arena.
  static Arena* OwnerOf(const void* block);
  // Frees a block of an arena.  Returns false, and changes nothing, if no block in use begins at
  // `block`, for example because it was freed already.  REQUIRES: OwnerOf(block) is not null.
  static bool Free(void* block);
  // Returns whether a block that was freed began at `block`.  REQUIRES: OwnerOf(block) is not null,
  // and no block in use begins at `block`.
  static bool WasFreed(const void* block);
  // Frees a block of an arena or of the host's heap.  A caller that got the block from Allocate()
  // must use this function and not free(): under Valgrind, free() is a function of Valgrind, which
  // does not know arenas.
  static void FreeAny(void* block);
  // Returns the number of bytes that may be used in `block`.  REQUIRES: OwnerOf(block) is not null.
  static size_t UsableSize(const void* block);

  // The calls that led to the allocation of a block: the addresses of the call instructions in the
  // object's image, from the innermost call to the outermost.
  using Calls = std::vector<const void*>;

  // Makes the arena keep, for each block that is allocated from now on, the calls that led to its
  // allocation.
  void KeepCalls() { calls_ = std::make_unique<std::map<uint32_t, Calls>>(); }
  bool keeps_calls() const { return calls_ != nullptr; }
  // Stores `calls`, the calls that led to the allocation of `block`, for reports of leaks.
  // REQUIRES: keeps_calls().
  void NoteCalls(const void* block, Calls calls);
  // Calls `visit`, in the order of addresses, for every block that is in use and whose calls
  // NoteCalls() has stored.  `calls` are the calls that led to the allocation of the block.
  void ForEachBlock(
      const std::function<void(char* block, size_t bytes, const Calls& calls)>& visit) const;

 private:
  static constexpr int kClasses = 44;
  static constexpr size_t kSpanBytes = size_t{64} << 10;
  static constexpr size_t kSpans = ObjectAddresses::kHeapBytes / kSpanBytes;

  // A span of 64 KiB.  It holds small blocks of one size class, or is the first or a later span of
  // a large block.
  struct Span {
    int16_t use = kFree;      // the index of a size class, or kFree, kLarge, kInside
    uint16_t span_count = 0;  // number of spans of a large block, kept in its first span
  };
  static constexpr int16_t kFree = -1, kLarge = -2, kInside = -3;

  struct FreeBlock {
    FreeBlock* next;
  };

  char* AllocateSpans(size_t count, int16_t use);
  void FreeSpans(size_t first);
  bool MapUpTo(size_t span_end);
  size_t IndexOf(const void* block) const {
    return static_cast<size_t>(static_cast<const char*>(block) - base_) / kSpanBytes;
  }
  size_t SizeOf(const void* block) const;
  void* AllocateSmall(int size_class);
  void* AllocateLarge(size_t size);
  bool FreeFrom(void* block);
  // Returns the index of a block in `begins_`, which has an element for each 16 bytes of memory.
  size_t PlaceOf(const void* block) const {
    return static_cast<size_t>(static_cast<const char*>(block) - base_) / 16;
  }
  bool IsBegin(const void* block) const;
  bool MayTake(size_t size);
  void Account(size_t size);

  // Returns span `index`, which is free if it is not mapped.
  const Span& SpanAt(size_t index) const {
    static constexpr Span kUnmapped;
    return index < mapped_spans_ ? spans_[index] : kUnmapped;
  }

  char* const base_;
  std::vector<Span> spans_;  // the mapped spans
  size_t first_free_ = 0;    // index of a span; no span before it is free
  size_t mapped_spans_ = 0;  // number of mapped spans, counted from the first span
  FreeBlock* free_[kClasses] = {};
  char* bump_[kClasses] = {};  // for each size class, the next block that was never used
  char* bump_end_[kClasses] = {};
  // Tells for each 16 bytes of the heap's mapped memory whether a block in use begins at these
  // bytes.
  std::vector<bool> begins_;
  // For each block, the calls that led to its allocation; the key is the result of PlaceOf().  Null
  // if calls are not kept.  The key is not the address of the block, because ReportLeaks() searches
  // the memory of this process for addresses of blocks and must not find them in this map.
  std::unique_ptr<std::map<uint32_t, Calls>> calls_;
  size_t in_use_ = 0;
  size_t in_use_max_ = 0;
  MemoryBudget own_budget_;
  MemoryBudget* budget_;
};

}  // namespace openr_host
