// The stack that the handlers of one image run on: at the addresses of its place, and full of zeros
// when a handler begins.
//
// Programs send bytes of their stack that they never set: padding, and members that a constructor
// forgot.  On the dispatcher's own stack these would be what the runtime and the C library left
// there.
#pragma once

#include <cstdint>

#include "runtime/core/stack_memory.h"

namespace openr_host {

// Makes the part of a planned stack zero that the next function called will use; on other stacks it
// does nothing.  Called in front of code of an image where the runtime has run before.
#if defined(__x86_64__)
extern "C" void openr_clear_stack(void);
#else
inline void openr_clear_stack() {}
#endif

class HandlerStack {
 public:
  // `address`: of the plan (address_plan.h).
  explicit HandlerStack(char* address) : memory_(address) {}

  // Calls function(argument) on the empty stack, or where the caller is when that is this stack
  // already, as for an entry that an object calls of itself.
  //
  // Afterwards the stack is cleared.  That takes time in proportion to how far one looks for bytes
  // that were written, so the first 64 calls and every 16th one look for them behind gaps of 32
  // KiB, the others behind gaps of 4 KiB.
  void Call(void (*function)(void*), void* argument);

 private:
  void Clear();

  StackMemory memory_;
  uint64_t calls_ = 0;
  bool is_dirty_ = false;  // a handler runs, or ended without returning, as by exit()
};

}  // namespace openr_host
