// The stack that the code of one image runs on: at the addresses of its place, full of zeros when
// a handler begins, and used by nobody else (imported_calls.h).
//
// Programs send bytes of their stack that they never set: padding, and members that a constructor
// forgot.  On a stack shared with the runtime and the C library, these would be what those left
// there: addresses that are others in each process.  Besides, what is used of this stack is what
// the object itself uses.
#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/core/stack_memory.h"

namespace openr_host {

class HandlerStack {
 public:
  // `address`: of the plan (address_plan.h); null: where the kernel puts it.
  explicit HandlerStack(char* address) : memory_(address) {}

  // Calls function(argument) on the empty stack, or where the caller is when this stack is in use
  // already, as for an entry that an object calls of itself.
  //
  // Afterwards the stack is cleared.  That takes time in proportion to how far one looks for bytes
  // that were written, so the first 64 calls and every 16th one look for them behind gaps of 32
  // KiB, the others behind gaps of 4 KiB.
  void Call(void (*function)(void*), void* argument);

  // How many bytes the last call has used, or the call under way has used so far.  0 where it is
  // not known: with AddressSanitizer and under Valgrind.
  size_t UsedBytes() const;

 private:
  void Clear();

  StackMemory memory_;
  uint64_t calls_ = 0;
  size_t used_bytes_ = 0;
  bool is_dirty_ = false;  // a handler runs, or ended without returning, as by exit()
};

}  // namespace openr_host
