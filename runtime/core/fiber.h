// Fiber: a stack on which handlers run, and the switch from one stack to another.
//
// The dispatcher runs on a fiber and calls handlers directly, so a handler that does not wait costs
// no switch.  A handler that waits keeps its fiber; the dispatcher continues on another fiber
// (docs/architecture.md, "How a handler waits").
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "runtime/core/stack_memory.h"
#include "runtime/core/watched_fiber.h"

namespace openr_host {

class Fiber {
 public:
  using Main = void (*)(void* argument);  // a function that never returns

  Fiber();
  ~Fiber() = default;
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  // Drops the content of this fiber's stack, so that the next switch to this fiber calls
  // main(argument) on an empty stack.  REQUIRES: this fiber is not running and has a stack of its
  // own.
  void Prepare(Main main, void* argument);

  // Saves the running stack in `from` and continues on this fiber's stack.  Returns when another
  // fiber switches back to `from`.  If `from` is null, gives the running stack up and never
  // returns.  The exceptions that the code on a stack is handling are saved and restored with the
  // stack.
  void SwitchFrom(Fiber* from);

 private:
  friend class MainFiber;
  struct NoStack {};
  explicit Fiber(NoStack);  // makes the fiber of the thread's own stack

  void FinishSwitch();

  void* context_ = nullptr;             // the state of the stack while the fiber is not running
  std::unique_ptr<StackMemory> stack_;  // null for the thread's own stack
  Main main_ = nullptr;
  void* argument_ = nullptr;
  // The exceptions that code on this fiber's stack is handling (__cxa_eh_globals), while the fiber
  // is not running.
  void* exceptions_[2] = {nullptr, nullptr};
  // Values that AddressSanitizer needs while the fiber is not running: the address of the fake
  // stack that AddressSanitizer has for this fiber, and the bounds of the stack on which the fiber
  // continues.
  void* fake_stack_ = nullptr;
  const void* stack_bottom_ = nullptr;
  size_t stack_bytes_ = 0;
  [[no_unique_address]] WatchedFiber watched_;
};

// The fiber for the stack of the thread itself, on which System::Run...() was called.
class MainFiber : public Fiber {
 public:
  MainFiber() : Fiber(NoStack{}) {}
};

}  // namespace openr_host
