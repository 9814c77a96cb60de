// Memory for a stack, with a guard page below it.  An overflow of the stack touches the guard page,
// which is a fault.
//
// A stack at a planned address (address_plan.h) is for code of one image.  Below it lies a second
// stack, for the functions that the image imports (imported_calls.h):
//
//     guard page | 752 KiB for imported functions | guard page | 256 KiB for the image | 4 KiB
//
// The last 4 KiB, above the image's stack, are only read.  A call of an imported function copies
// its arguments from the image's stack.  The size of the arguments is not known, so a fixed number
// of bytes is copied.  Near the top of the stack, the copy therefore reads bytes beyond the stack,
// which lie in these 4 KiB.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/core/address_plan.h"

namespace openr_host {

class StackMemory {
 public:
  // The size of the stack on which the code of an image runs.  The size is our choice.  It can be
  // large, because pages that were never touched use no memory.
  static constexpr size_t kBytes = size_t{256} << 10;

  // The size of a guard page, which lies below a stack and makes an overflow of the stack a fault.
  static constexpr size_t kGuardBytes = 4096;
  // Offset of the top of the stack for the image's own code, from the first address of the memory
  // that the address plan gives to an image for its stacks.  The assembly code of imported_calls.cc
  // contains kBottomOffset and kImportsTopOffset as numbers; static_asserts in that file check
  // these numbers.
  static constexpr size_t kTopOffset = ObjectAddresses::kStackBytes - 4096;
  // Offset of the bottom of the stack for the image's own code, from the first address of the
  // memory for the stacks of the image.
  static constexpr size_t kBottomOffset = kTopOffset - kBytes;
  // Offset of the top of the stack for imported functions, from the first address of the memory for
  // the stacks of the image.
  static constexpr size_t kImportsTopOffset = kBottomOffset - kGuardBytes;

  // Maps the memory at `address`.  If `address` is null or in use, the kernel chooses the address.
  explicit StackMemory(char* address = nullptr);
  ~StackMemory();
  StackMemory(const StackMemory&) = delete;
  StackMemory& operator=(const StackMemory&) = delete;

  char* bottom() const { return bottom_; }
  char* top() const { return bottom_ + kBytes; }  // the stack grows down from here

  // Returns whether `address` lies on this stack or on the stack for imported functions, which is
  // mapped below it.
  bool Contains(const void* address) const {
    return address >= mapping_ && address < mapping_ + mapped_bytes_;
  }

  // Returns the distance in bytes from the top of this stack to the lowest byte that was written
  // to, that is, to the lowest byte that is not 0.  The search goes from the top down and stops
  // after `gap_bytes` of zeros.  So written bytes below an unwritten array of `gap_bytes` bytes are
  // not found.  If `gap_bytes` is larger than kSmallGapBytes, the search does not read pages that
  // were never used.  Returns 0 with AddressSanitizer and under Valgrind, which do not allow these
  // reads.  REQUIRES: the caller runs on another stack.
  size_t UsedBytes(size_t gap_bytes) const;

  // Sets to zero the bytes of this stack that UsedBytes(gap_bytes) counts, and returns their
  // number.  So the next handler finds a stack of zeros, and if it sends bytes that it has not set,
  // these bytes are the same in every run.
  size_t Clear(size_t gap_bytes);

  // Tells AddressSanitizer that this stack is empty.  Functions that never returned have left marks
  // for their variables in the shadow memory of AddressSanitizer.  With these marks,
  // AddressSanitizer would report the next use of the memory as an error.
  void ForgetFrames() const;

  static constexpr size_t kWideGapBytes = size_t{32} << 10;
  static constexpr size_t kSmallGapBytes = size_t{4} << 10;

  // Returns whether `address` lies in a guard page of a stack of this thread.  If an access to such
  // an address was a fault, the stack above the guard page has overflowed.
  static bool AnyGuardContains(const void* address);

  // Returns the readable memory of all stacks of this thread: the first address and the number of
  // bytes of each part.  Guard pages are left out, because they cannot be read.
  static std::vector<std::pair<const char*, size_t>> All();

 private:
  char* mapping_;
  size_t mapped_bytes_ = kGuardBytes + kBytes;
  char* bottom_;
  // The stack of this thread that was made before this stack.  These pointers make a list of all
  // stacks of the thread.
  StackMemory* older_;
  unsigned valgrind_id_ = 0;
  // A bit for each page of the stack: whether UsedBytes() has seen that the page has memory.
  mutable uint64_t known_pages_ = 0;
};

}  // namespace openr_host
