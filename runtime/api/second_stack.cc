#include "runtime/api/second_stack.h"

#include <string>
#include <vector>

#include "runtime/base/assert.h"
#include "runtime/base/spelling.h"
#include "runtime/core/current.h"
#include "runtime/core/fiber.h"
#include "runtime/core/fp_flags.h"
#include "runtime/core/handler_stack.h"
#include "runtime/core/stack_report.h"
#include "runtime/core/system.h"

using openr_host::ApiScope;
using openr_host::ArithmeticWatch;
using openr_host::t_current;

// A second stack, on which an object runs the function `body`.  The function may leave the stack
// before its end and continue later, as the endless loop of a controller does (kit/controller).
//
// The functions that switch stacks make no ApiScope (current.h), although programs call them.  An
// ApiScope would mark `body` as code of the runtime, so that `body` would use the heap and files of
// the host.
struct OpenrSecondStack {
  // The second stack lies at addresses that are planned for the object (core/address_plan.h), as
  // the stack of handlers does.  It is cleared after use, so that its content is the same in every
  // run.
  openr_host::HandlerStack stack{Address()};
  openr_host::Fiber fiber;        // calls the function `body` on `stack`
  openr_host::MainFiber handler;  // the handler that switched to `stack`
  void (*body)(void*) = nullptr;
  void* argument = nullptr;
  // Finds floating-point operations in the function `body` that would stop the robot, such as 0/0.
  ArithmeticWatch watch;
  // The floating-point flags (NaN, overflow ...) that the function `body` has raised on this stack.
  // The switch back to the handler's stack loses these flags.  So SwitchToHandler() stores them
  // here before the switch, and SwitchToSecondStack() adds them to the handler's flags after the
  // switch.
  unsigned fp_flags = 0;
  bool has_left = false;  // true while the function `body` waits to be continued

  static char* Address() {
    const openr_host::ObjectAddresses* const addresses = t_current.object->memory().addresses();
    return addresses == nullptr ? nullptr : addresses->stack(1);
  }

  static void Main(void* self) { static_cast<OpenrSecondStack*>(self)->Run(); }

  void Run() {
    watch.Begin(openr_host::kFpCaught);
    stack.Call(body, argument);
    SwitchToHandler();
    // The program never reaches this line.  SwitchToHandler() has switched to the stack of the
    // handler, and nothing switches back to a stack whose function has ended.
    __builtin_unreachable();
  }

  // Switches from the second stack back to the stack of the handler.  The switch restores the
  // handler's floating-point flags, and so loses the flags that code on the second stack has
  // raised.  Stores these flags in `fp_flags` first, because the object is checked for them when
  // the handler ends.
  void SwitchToHandler() {
    fp_flags = openr_host::FpFlags();
    if (fp_flags != 0) openr_host::ClearFpFlags();
    handler.SwitchFrom(&fiber);
  }

  // Switches from the stack of the handler to the second stack.  Returns when the function on the
  // second stack has ended, or has switched back to continue later.  Then counts the used bytes of
  // the second stack as stack of the object, because on the robot an object has only one stack.
  void SwitchToSecondStack() {
    ArithmeticWatch* const outer = t_current.watch;
    t_current.watch = &watch;
    fiber.SwitchFrom(&handler);
    t_current.watch = outer;
    if (fp_flags != 0) openr_host::SetFpState(openr_host::FpState() | fp_flags);
    if (t_current.system->options().measure_stacks)
      openr_host::NoteStackUse(t_current.object, stack.UsedBytes());
  }
};

OpenrSecondStack* openr_second_stack_new() {
  const ApiScope scope;
  return new OpenrSecondStack;
}

void openr_second_stack_delete(OpenrSecondStack* stack) {
  const ApiScope scope;
  delete stack;
}

void openr_second_stack_run(OpenrSecondStack* stack, void (*body)(void*), void* argument) {
  stack->body = body;
  stack->argument = argument;
  stack->has_left = false;
  stack->watch = ArithmeticWatch();
  stack->fiber.Prepare(&OpenrSecondStack::Main, stack);
  stack->SwitchToSecondStack();
}

void openr_second_stack_leave(OpenrSecondStack* stack) {
  stack->has_left = true;
  stack->SwitchToHandler();
}

void openr_second_stack_continue(OpenrSecondStack* stack) {
  ASSERT(stack->has_left, "a second stack can only be continued where it was left");
  stack->has_left = false;
  stack->SwitchToSecondStack();
}

void openr_finding_of_name(const char* text, const char* name, const char* const* known,
                           int count) {
  const ApiScope scope;
  const std::vector<std::string> names(known, known + count);
  openr_finding((text + openr_host::DidYouMean(name, names)).c_str());
}

void openr_finding(const char* text) {
  const ApiScope scope;
  if (t_current.system == nullptr) return;
  t_current.system->AddFinding(openr_host::Severity::kWarning, text);
}
