#include "runtime/core/fiber.h"

#include <cxxabi.h>

#include <boost/context/detail/fcontext.hpp>
#include <cstdint>
#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/core/memory_tools.h"

namespace openr_host {

namespace context = boost::context::detail;

namespace {

// The fibers that the current switch leaves and enters.  The code after a switch runs on another
// stack and would not find local variables of the code before it.
thread_local Fiber* t_left = nullptr;
thread_local Fiber* t_entered = nullptr;

// Tells AddressSanitizer that a stack is empty.  Functions that never returned have left marks for
// their variables in the shadow memory of AddressSanitizer.  With these marks, AddressSanitizer
// would report the next use of the stack as an error.
void ForgetFrames(const void* bottom, size_t bytes) {
  if (IsAddressSanitized()) __asan_unpoison_memory_region(bottom, bytes);
}

}  // namespace

Fiber::Fiber(NoStack) {}

Fiber::Fiber() : stack_(std::make_unique<StackMemory>()) {
  stack_bottom_ = stack_->bottom();
  stack_bytes_ = StackMemory::kBytes;
}

Fiber::~Fiber() {
  if (stack_ != nullptr) ForgetFrames(stack_bottom_, stack_bytes_);
}

void Fiber::Prepare(Main main, void* argument) {
  ASSERT(stack_ != nullptr, "the thread's own stack cannot be prepared");
  ForgetFrames(stack_bottom_, stack_bytes_);
  main_ = main;
  argument_ = argument;
  exceptions_[0] = exceptions_[1] = nullptr;
  fake_stack_ = nullptr;
  const auto entry = [](context::transfer_t transfer) {
    t_left->context_ = transfer.fctx;
    Fiber* const self = t_entered;
    self->FinishSwitch();
    self->main_(self->argument_);
  };
  context_ = context::make_fcontext(stack_->top(), StackMemory::kBytes, entry);
}

void Fiber::SwitchFrom(Fiber* from) {
  // Takes the place of a null `from`, so that the code below needs no special case.  The state of
  // the running stack is then saved in `nowhere`, and nothing reads it.
  static thread_local Fiber* const nowhere = new MainFiber;
  const bool forever = from == nullptr;
  if (forever) from = nowhere;
  void* const globals = abi::__cxa_get_globals();
  std::memcpy(from->exceptions_, globals, sizeof from->exceptions_);
  std::memcpy(globals, exceptions_, sizeof exceptions_);
  t_left = from;
  t_entered = this;
  if (IsAddressSanitized()) {
    __sanitizer_start_switch_fiber(forever ? nullptr : &from->fake_stack_, stack_bottom_,
                                   stack_bytes_);
  }
  const context::transfer_t transfer = context::jump_fcontext(context_, nullptr);
  // This code runs when another fiber has switched back to `from`.  That other fiber is t_left now,
  // and the state of its stack is known only here.
  t_left->context_ = transfer.fctx;
  from->FinishSwitch();
}

void Fiber::FinishSwitch() {
  if (!IsAddressSanitized()) return;
  const void* bottom = nullptr;
  size_t bytes = 0;
  __sanitizer_finish_switch_fiber(fake_stack_, &bottom, &bytes);
  // Keeps the bounds of the thread's own stack, which AddressSanitizer needs for the switch back to
  // this stack.  AddressSanitizer tells these bounds only at a switch away from the stack.
  if (t_left->stack_ == nullptr) {
    t_left->stack_bottom_ = bottom;
    t_left->stack_bytes_ = bytes;
  }
}

}  // namespace openr_host
