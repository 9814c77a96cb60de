#include "runtime/core/handler_stack.h"

#include "runtime/core/address_plan.h"
#include "runtime/core/memory_tools.h"

#if defined(__x86_64__)

// Calls function(argument) with the stack pointer at `top`, a multiple of 16.  What unwinds the
// stack, exceptions and debuggers, finds the way back by the frame pointer.
extern "C" void openr_call_on_stack(void (*function)(void*), void* argument, void* top);
asm(R"(
    .text
    .globl openr_call_on_stack
    .hidden openr_call_on_stack
    .type openr_call_on_stack, @function
openr_call_on_stack:
    .cfi_startproc
    pushq %rbp
    .cfi_def_cfa_offset 16
    .cfi_offset %rbp, -16
    movq %rsp, %rbp
    .cfi_def_cfa_register %rbp
    movq %rdx, %rsp
    movq %rdi, %rax
    movq %rsi, %rdi
    callq *%rax
    movq %rbp, %rsp
    popq %rbp
    .cfi_def_cfa %rsp, 8
    ret
    .cfi_endproc
    .size openr_call_on_stack, .-openr_call_on_stack
)");

// Makes 2 KiB below the caller's frame zero, if the caller runs on a planned stack (address_plan.h:
// the addresses below 17 TiB), and if so much is left above the guard page.  Has no frame of its
// own, so nothing stays but the address that it returns to.
extern "C" {
__attribute__((visibility("hidden"))) bool openr_clears_stacks = !openr_host::IsStackWatched();
}
asm(R"(
    .text
    .globl openr_clear_stack
    .type openr_clear_stack, @function
openr_clear_stack:
    .cfi_startproc
    cmpb $0, openr_clears_stacks(%rip)
    je 1f
    movq %rsp, %rax
    shrq $40, %rax
    cmpq $17, %rax
    jae 1f
    movl %esp, %eax
    andl $0x7ffff, %eax
    cmpl $0x2000, %eax
    jb 1f
    leaq -2048(%rsp), %rdi
    movl $256, %ecx
    xorl %eax, %eax
    rep stosq
1:  ret
    .cfi_endproc
    .size openr_clear_stack, .-openr_clear_stack
)");

#endif

namespace openr_host {

#if defined(__x86_64__)

// openr_clear_stack() finds the begin of a stack by its address.
static_assert(AddressPlace::kStackBytes == 0x80000);

void HandlerStack::Call(void (*function)(void*), void* argument) {
  const char* const here = static_cast<const char*>(__builtin_frame_address(0));
  if (here >= memory_.bottom() && here < memory_.top()) {
    function(argument);
    return;
  }
  struct Clearing {  // also after a handler that ends by an exception
    HandlerStack* stack;
    ~Clearing() { stack->Clear(); }
  };
  if (is_dirty_) Clear();
  is_dirty_ = true;
  const Clearing clearing{this};
  openr_call_on_stack(function, argument, memory_.top());
}

void HandlerStack::Clear() {
  ++calls_;
  const bool looks_far = calls_ <= 64 || calls_ % 16 == 0;
  memory_.Clear(looks_far ? StackMemory::kWideGapBytes : StackMemory::kSmallGapBytes);
  is_dirty_ = false;
}

#else

void HandlerStack::Call(void (*function)(void*), void* argument) { function(argument); }

#endif

}  // namespace openr_host
