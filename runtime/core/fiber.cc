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

// The fibers that the current switch leaves and enters.  They are no local variables, because the
// code after a switch runs on another stack and would not find the local variables of the code
// before it.
thread_local Fiber* t_left = nullptr;
thread_local Fiber* t_entered = nullptr;

}  // namespace

Fiber::Fiber(NoStack) {}

Fiber::Fiber() : stack_(std::make_unique<StackMemory>()) {}

void Fiber::Prepare(Main main, void* argument) {
  ASSERT(stack_ != nullptr, "the thread's own stack cannot be prepared");
  stack_->ForgetFrames();
  stack_bottom_ = stack_->bottom();
  stack_bytes_ = StackMemory::kBytes;
  main_ = main;
  argument_ = argument;
  exceptions_[0] = exceptions_[1] = nullptr;
  fake_stack_ = nullptr;
  watched_.Begin();
  const auto entry = [](context::transfer_t transfer) {
    t_left->context_ = transfer.fctx;
    Fiber* const self = t_entered;
    self->FinishSwitch();
    self->main_(self->argument_);
  };
  context_ = context::make_fcontext(stack_->top(), StackMemory::kBytes, entry);
}

void Fiber::SwitchFrom(Fiber* from) {
  // Stands in for `from` if `from` is null, so that the rest of this function needs no special
  // case.  The state of the running stack is then saved in `nowhere`, where nothing reads it.
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
  from->watched_.Leave();
  watched_.Enter();
  const context::transfer_t transfer = context::jump_fcontext(context_, nullptr);
  // This code runs when another fiber, t_left, has switched back to `from`.  Only now is the place
  // known where t_left stopped (transfer.fctx), so it is stored here for t_left.
  t_left->context_ = transfer.fctx;
  from->FinishSwitch();
}

void Fiber::FinishSwitch() {
  if (!IsAddressSanitized()) return;
  // Stores in t_left, the fiber that was left, the bounds of the stack that it used last, because
  // AddressSanitizer needs these bounds for the switch back.  This stack is not always the fiber's
  // own: the fiber may have called a handler of an image, which runs on a stack of its own
  // (handler_stack.h).
  __sanitizer_finish_switch_fiber(fake_stack_, &t_left->stack_bottom_, &t_left->stack_bytes_);
}

}  // namespace openr_host
