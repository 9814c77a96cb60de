// Memory for a stack, with a guard page below that faults when the stack overflows.
//
// A stack at a planned address (address_plan.h) is for code of one image.  Below it lies a second
// one, on which the functions run that the image imports (imported_calls.h):
//
//     guard page | 752 KiB for imported functions | guard page | 256 KiB for the image | 4 KiB
//
// The last 4 KiB are never written to.  They are there because arguments on the stack are copied
// without knowing how many there are.
#pragma once

#include <cstddef>

#include "runtime/core/address_plan.h"

namespace openr_host {

class StackMemory {
 public:
  // Address space only, until touched.
  static constexpr size_t kBytes = size_t{256} << 10;

  // Offsets from a planned address.
  static constexpr size_t kGuardBytes = 4096;
  static constexpr size_t kTopOffset = AddressPlace::kStackBytes - 4096;
  static constexpr size_t kBottomOffset = kTopOffset - kBytes;
  static constexpr size_t kImportsTopOffset = kBottomOffset - kGuardBytes;

  // At `address` if that is not null and nothing else lies there, else where the kernel puts it.
  explicit StackMemory(char* address = nullptr);
  ~StackMemory();
  StackMemory(const StackMemory&) = delete;
  StackMemory& operator=(const StackMemory&) = delete;

  char* bottom() const { return bottom_; }
  char* top() const { return bottom_ + kBytes; }  // the stack grows down from here

  // Whether `address` lies on this stack or on the one for imported functions.
  bool Contains(const void* address) const {
    return address >= mapping_ && address < mapping_ + mapped_bytes_;
  }

  // How many bytes calls that have returned wrote to, from the top.  Looks for bytes that are not
  // zero from the top down, and no further than `gap_bytes` below the last one, so an array of
  // that size that nobody wrote to hides what lies below it.  0 with AddressSanitizer and under
  // Valgrind, which watch these bytes themselves.  REQUIRES: the caller runs on another stack.
  size_t UsedBytes(size_t gap_bytes) const;

  // Makes these bytes zero, and returns how many they were.
  size_t Clear(size_t gap_bytes);

  static constexpr size_t kWideGapBytes = size_t{32} << 10;
  static constexpr size_t kSmallGapBytes = size_t{4} << 10;

  // Whether `address` lies in a guard page of any stack of this thread: that stack overflowed.
  static bool AnyGuardContains(const void* address);

 private:
  char* mapping_;
  size_t mapped_bytes_ = kGuardBytes + kBytes;
  char* bottom_;
  StackMemory* older_;  // the next one in the list of this thread's stacks
  unsigned valgrind_id_ = 0;
};

}  // namespace openr_host
