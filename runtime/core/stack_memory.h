// Memory for a stack, with a guard page below that faults when the stack overflows.
#pragma once

#include <cstddef>

namespace openr_host {

class StackMemory {
 public:
  // 256 KiB, address space only until touched.
  static constexpr size_t kBytes = size_t{256} << 10;

  // At `address` if that is not null and nothing else lies there, else where the kernel puts it.
  explicit StackMemory(char* address = nullptr);
  ~StackMemory();
  StackMemory(const StackMemory&) = delete;
  StackMemory& operator=(const StackMemory&) = delete;

  char* bottom() const { return mapping_ + kGuardBytes; }
  char* top() const { return bottom() + kBytes; }  // the stack grows down from here

  // Makes zero what calls that have returned wrote there.  Looks for bytes that are not zero from
  // the top down, and no further than `gap_bytes` below the last one, so what lies below an array
  // of that size that nobody wrote to may stay.  Does nothing with AddressSanitizer and under
  // Valgrind, which watch these bytes themselves.  REQUIRES: the caller runs on another stack.
  void Clear(size_t gap_bytes);

  static constexpr size_t kWideGapBytes = size_t{32} << 10;
  static constexpr size_t kSmallGapBytes = size_t{4} << 10;

  // Whether `address` lies in the guard page of any stack of this thread: that stack overflowed.
  static bool AnyGuardContains(const void* address);

 private:
  static constexpr size_t kGuardBytes = 4096;

  char* mapping_;
  StackMemory* older_;  // the next one in the list of this thread's stacks
  unsigned valgrind_id_ = 0;
};

}  // namespace openr_host
