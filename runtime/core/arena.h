// The heap of one object: freed as a whole when the object goes.
//
// Memory comes in spans of 1 MiB out of one reserved range of addresses, so that
// any address tells in O(1) whose it is; free() works from anywhere.  Small
// blocks live in size classes with free lists, large ones get spans of their own.
// What an object may take is bounded by the memory of its robot, which all its objects
// share (the .ocf heap size is a step of growth, no limit).
#pragma once

#include <cstddef>
#include <cstdint>

namespace openr_host {

// The memory of one robot.
struct MemoryBudget {
  size_t limit_bytes = SIZE_MAX;
  size_t used_bytes = 0;
  int allocations_until_failure = -1;  // for tests: 1 fails the next; < 0: never
};

class Arena {
 public:
  // A null `budget` is without limit; otherwise it must outlive the arena.
  explicit Arena(MemoryBudget* budget = nullptr);
  ~Arena();  // every block is gone afterwards
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  // Null when the budget or the range is exhausted.  Alignment is 16, or
  // `alignment` if that is larger; REQUIRES: a power of two.
  void* Allocate(size_t size, size_t alignment = 16);

  size_t bytes_in_use() const { return in_use_; }
  size_t bytes_in_use_max() const { return in_use_max_; }

  // The arena that `block` came from; null when it is not an arena's.
  static Arena* OwnerOf(const void* block);
  // REQUIRES: OwnerOf(block) is not null.
  static void Free(void* block);
  static size_t UsableSize(const void* block);

 private:
  static constexpr int kClasses = 44;

  struct FreeBlock {
    FreeBlock* next;
  };

  void* AllocateSmall(int size_class);
  void* AllocateLarge(size_t size);
  void FreeFrom(void* block);
  bool MayTake(size_t size);
  void Account(size_t size);

  FreeBlock* free_[kClasses] = {};
  char* bump_[kClasses] = {};  // next never-used block of the class
  char* bump_end_[kClasses] = {};
  size_t in_use_ = 0;
  size_t in_use_max_ = 0;
  MemoryBudget own_budget_;
  MemoryBudget* const budget_;
};

}  // namespace openr_host
