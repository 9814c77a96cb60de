// The functions of objects/Controller/LoopStack.h for the host, where the main() of a controller
// may be an endless loop.  The loop runs on a second stack: robot_step() leaves that stack, and
// after the time step the Controller object continues the loop.  This file becomes a part of
// images, so it is written in gnu++98.
#include "LoopStack.h"

#include "runtime/api/second_stack.h"

namespace {

// The second stack, on which the main() of a controller runs.  It is destroyed with the image: when
// the run ends, when the robot boots again, or when the image is loaded again.
struct Stack {
  Stack() : stack(0) {}
  ~Stack() { openr_second_stack_delete(stack); }
  OpenrSecondStack* stack;
};
Stack the_stack;

}  // namespace

void LoopStackRun(void (*body)(void*), void* argument) {
  if (the_stack.stack == 0) the_stack.stack = openr_second_stack_new();
  openr_second_stack_run(the_stack.stack, body, argument);
}

bool LoopStackLeave() {
  openr_second_stack_leave(the_stack.stack);
  return true;
}

void LoopStackContinue() { openr_second_stack_continue(the_stack.stack); }

void TellRunner(const char* text) { openr_finding(text); }

void TellRunnerOfName(const char* text, const char* name, const char* const* known, int count) {
  openr_finding_of_name(text, name, known, count);
}
