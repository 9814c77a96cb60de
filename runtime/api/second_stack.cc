#include "runtime/api/second_stack.h"

#include <algorithm>
#include <string>
#include <vector>

#include "runtime/config/spelling.h"
#include "runtime/core/assert.h"
#include "runtime/core/current.h"
#include "runtime/core/fiber.h"
#include "runtime/core/system.h"

using openr_host::ApiScope;
using openr_host::t_current;

// No ApiScope around a switch: whether code of the image runs is the same on both sides.
struct OpenrSecondStack {
  // At the addresses of its object's place, like the stack of handlers, and as clean.
  openr_host::Fiber fiber{Address()};
  openr_host::MainFiber home;  // the method that went there, on whichever stack
  void (*body)(void*) = nullptr;
  void* argument = nullptr;
  bool has_left = false;

  static char* Address() {
    const auto& place = t_current.object->place;
    return place == nullptr ? nullptr : place->stack(1);
  }

  static void Main(void* self) { static_cast<OpenrSecondStack*>(self)->Run(); }

  void Run() {
    body(argument);
    GoHome();
    __builtin_unreachable();  // an ended body is not continued
  }

  // It counts as stack of the object: on the robot there is only one.
  void GoHome() {
    size_t& most = t_current.object->stack_max;
    if (t_current.system->options().measure_stacks)
      most = std::max(most, fiber.stack()->Used(openr_host::StackMemory::kWideGapBytes));
    home.SwitchFrom(&fiber);
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
  stack->fiber.stack()->Clear(openr_host::StackMemory::kWideGapBytes);
  stack->fiber.Prepare(&OpenrSecondStack::Main, stack);
  stack->fiber.SwitchFrom(&stack->home);
}

void openr_second_stack_leave(OpenrSecondStack* stack) {
  stack->has_left = true;
  stack->GoHome();
}

void openr_second_stack_continue(OpenrSecondStack* stack) {
  ASSERT(stack->has_left, "a second stack can only be continued where it was left");
  stack->has_left = false;
  stack->fiber.SwitchFrom(&stack->home);
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
