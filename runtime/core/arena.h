// The heap of one object: freed as a whole when the object goes.
//
// Memory comes in spans of 1 MiB out of one reserved range of addresses, so that
// any address tells in O(1) whose it is; free() works from anywhere.  Small
// blocks live in size classes with free lists, large ones get spans of their own.
// The range is the only limit unless set_limit_bytes() sets one; the program does not
// do so yet, not even with --strict (the .ocf heap size is a step of growth, no limit).
#pragma once

#include <cstddef>
#include <cstdint>

namespace openr_host {

class Arena {
 public:
  Arena();
  ~Arena();  // every block is gone afterwards
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  // Null when the limit or the range is exhausted.  Alignment is 16, or
  // `alignment` if that is larger; REQUIRES: a power of two.
  void* Allocate(size_t size, size_t alignment = 16);

  size_t bytes_in_use() const { return in_use_; }
  size_t bytes_in_use_max() const { return in_use_max_; }
  void set_limit_bytes(size_t limit) { limit_ = limit; }

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
  void Account(size_t size);

  FreeBlock* free_[kClasses] = {};
  char* bump_[kClasses] = {};  // next never-used block of the class
  char* bump_end_[kClasses] = {};
  size_t in_use_ = 0;
  size_t in_use_max_ = 0;
  size_t limit_ = SIZE_MAX;
};

}  // namespace openr_host
