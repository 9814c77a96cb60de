#include "runtime/core/handler_stack.h"

#include "runtime/core/memory_tools.h"

#if defined(__x86_64__)

// Calls function(argument) with the stack pointer at `top`, a multiple of 16.
//
// First sets the registers to 0 that `function` may save on the new stack.  They may hold addresses
// of the host, which differ from run to run, and an object may read them from the stack by mistake.
// So the object finds the same bytes in every run.
//
// To return, this function needs the address of its own frame on the old stack.  It stores this
// address at the top of the new stack, above all frames of the object.  `.cfi_escape` tells
// exceptions and debuggers where to read it: *(rsp + 8) + 16 is the canonical frame address.
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
    pushq %rbx
    .cfi_offset %rbx, -24
    pushq %r12
    .cfi_offset %r12, -32
    pushq %r13
    .cfi_offset %r13, -40
    pushq %r14
    .cfi_offset %r14, -48
    pushq %r15
    .cfi_offset %r15, -56
    movq %rbp, -8(%rdx)
    leaq -16(%rdx), %rsp
    .cfi_remember_state
    .cfi_escape 0x0f, 0x05, 0x77, 0x08, 0x06, 0x23, 0x10
    movq %rdi, %rax
    movq %rsi, %rdi
    xorl %ebx, %ebx
    xorl %ebp, %ebp
    xorl %r12d, %r12d
    xorl %r13d, %r13d
    xorl %r14d, %r14d
    xorl %r15d, %r15d
    callq *%rax
    movq 8(%rsp), %rbp
    .cfi_restore_state
    leaq -40(%rbp), %rsp
    popq %r15
    popq %r14
    popq %r13
    popq %r12
    popq %rbx
    popq %rbp
    .cfi_def_cfa %rsp, 8
    ret
    .cfi_endproc
    .size openr_call_on_stack, .-openr_call_on_stack
)");

#endif

namespace openr_host {

#if defined(__x86_64__)

namespace {

struct SanitizedCall {
  void (*function)(void*);
  void* argument;
  // The first address (`bottom`) and the size (`bytes`) of the stack from which the handler's
  // function was called.  AddressSanitizer must get both values when the handler's function has
  // ended and its caller continues on that stack.
  const void* bottom = nullptr;
  size_t bytes = 0;
};

// Calls the function of `data`, a SanitizedCall, on the handler's stack, and tells AddressSanitizer
// when the use of this stack begins and when it ends.  Otherwise AddressSanitizer would take the
// handler's stack for a part of another stack, and would keep marks for stack frames that an
// exception has ended.
void CallWithStackMarks(void* data) {
  SanitizedCall* const call = static_cast<SanitizedCall*>(data);
  __sanitizer_finish_switch_fiber(nullptr, &call->bottom, &call->bytes);
  struct StackSwitch {
    const SanitizedCall* call;
    ~StackSwitch() { __sanitizer_start_switch_fiber(nullptr, call->bottom, call->bytes); }
  };
  const StackSwitch departure{call};
  call->function(call->argument);
}

}  // namespace

void HandlerStack::Call(void (*function)(void*), void* argument) {
  if (memory_.Contains(__builtin_frame_address(0))) {
    function(argument);
    return;
  }
  // Clears the handler's stack in its destructor, so also if the handler ends with an exception.
  struct Clearing {
    HandlerStack* stack;
    ~Clearing() { stack->Clear(); }
  };
  if (is_dirty_) Clear();
  is_dirty_ = true;
  const Clearing clearing{this};
  if (IsAddressSanitized()) {
    CallWithSanitizer(function, argument);
  } else {
    openr_call_on_stack(function, argument, memory_.top());
  }
}

void HandlerStack::CallWithSanitizer(void (*function)(void*), void* argument) {
  memory_.ForgetFrames();
  SanitizedCall call{function, argument};
  void* fake_stack = nullptr;
  // In its destructor, tells AddressSanitizer that the stack from which CallWithSanitizer() was
  // called is in use again.  A destructor also runs if `function` ends with an exception.
  struct StackReturn {
    void* const* fake_stack;
    ~StackReturn() { __sanitizer_finish_switch_fiber(*fake_stack, nullptr, nullptr); }
  };
  const StackReturn arrival{&fake_stack};
  __sanitizer_start_switch_fiber(&fake_stack, memory_.bottom(), StackMemory::kBytes);
  openr_call_on_stack(&CallWithStackMarks, &call, memory_.top());
}

#else

void HandlerStack::Call(void (*function)(void*), void* argument) { function(argument); }

#endif

void HandlerStack::Clear() {
  ++calls_;
  // The search for written bytes ends at a gap of zeros.  A search for a wide gap finds more but
  // takes longer (see Call()), so it is done only after some of the calls.  After the others a
  // narrow gap is enough.
  const bool looks_far = calls_ <= 64 || calls_ % 16 == 0;
  used_bytes_ = memory_.Clear(looks_far ? StackMemory::kWideGapBytes : StackMemory::kSmallGapBytes);
  is_dirty_ = false;
}

size_t HandlerStack::UsedBytes() const {
  return is_dirty_ ? memory_.UsedBytes(StackMemory::kSmallGapBytes) : used_bytes_;
}

}  // namespace openr_host
