// HandlerStack: a stack on which only the code of one image (a program of the robot) runs.  It lies
// at the planned addresses of the object and is full of zeros when a handler begins.  Functions
// that the image imports run on another stack (imported_calls.h).
//
// Programs send bytes of their stack that they have never set: padding, and members that a
// constructor forgot.  If the runtime and the C library also used this stack, such bytes would be
// addresses that differ from process to process.
//
// The stack has a second use: the number of bytes written on it shows how much stack the object
// itself needs.
#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/core/stack_memory.h"

namespace openr_host {

class HandlerStack {
 public:
  // Maps the memory of this stack at `address` of the address plan (address_plan.h).  If `address`
  // is null, the kernel chooses the address.
  explicit HandlerStack(char* address) : memory_(address) {}

  // Calls function(argument) on the empty stack.  If the caller runs on this stack already, because
  // an object calls an entry of its own, calls the function directly.
  //
  // Afterwards clears the bytes that the function has written.  The search for these bytes goes
  // down from the top of the stack and ends at a gap of zeros, where nothing seems to be written.
  // But a gap may also be an array that the function did not set, with written bytes below it.  A
  // search that ends only at a wide gap misses fewer such bytes, but takes longer.  So the first 64
  // calls and every 16th call (our choice) search for a gap of 32 KiB, the other calls for a gap of
  // 4 KiB.
  void Call(void (*function)(void*), void* argument);

  // Returns how many bytes of this stack the handler of the newest Call() has used, or has used so
  // far if this handler is still running.  Returns 0 with AddressSanitizer and under Valgrind,
  // where the number is not known.
  size_t UsedBytes() const;

 private:
  void CallWithSanitizer(void (*function)(void*), void* argument);
  void Clear();

  StackMemory memory_;
  uint64_t calls_ = 0;
  size_t used_bytes_ = 0;
  // True if the stack may have bytes that are not zero: while a handler runs, and after a handler
  // that did not return, for example because of exit().
  bool is_dirty_ = false;
};

}  // namespace openr_host
