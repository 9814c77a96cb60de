// Stacks that handlers run on, and the switch between them.
//
// The dispatcher runs on a fiber and calls handlers directly, so a handler that
// simply returns costs no switch.  A handler that waits keeps its fiber; the
// dispatcher goes on on another one (architecture.md, "Settled" 2).
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "runtime/core/stack_memory.h"

namespace openr_host {

class Fiber {
 public:
  using Main = void (*)(void* argument);  // never returns

  Fiber();
  ~Fiber();
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  // Forgets whatever ran here; the next switch to it calls main(argument) on an
  // empty stack.  REQUIRES: this fiber is not running.
  void Prepare(Main main, void* argument);

  // Leaves the running stack for this one; returns when somebody switches back
  // to `from`.  A null `from` is a stack that is never returned to.
  // Exceptions being handled belong to the stack and are kept with it.
  void SwitchFrom(Fiber* from);

 private:
  friend class MainFiber;
  struct NoStack {};
  explicit Fiber(NoStack);  // the thread's own stack

  void FinishSwitch();

  void* context_ = nullptr;             // where to continue
  std::unique_ptr<StackMemory> stack_;  // null for the thread's own stack
  Main main_ = nullptr;
  void* argument_ = nullptr;
  void* exceptions_[2] = {nullptr, nullptr};  // __cxa_eh_globals while not running
  void* fake_stack_ = nullptr;                // AddressSanitizer's
  const void* stack_bottom_ = nullptr;
  size_t stack_bytes_ = 0;
};

// The stack of the caller of System::Run...().
class MainFiber : public Fiber {
 public:
  MainFiber() : Fiber(NoStack{}) {}
};

}  // namespace openr_host
