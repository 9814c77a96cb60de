//
// Implements LoopStack.h for the robot, where an object has only one stack.
//

#include "LoopStack.h"

void
LoopStackRun(void (*body)(void*), void* argument)
{
    body(argument);
}

bool
LoopStackLeave()
{
    return false;
}

void
LoopStackContinue()
{
}

void
TellRunner(const char*)
{
}

void
TellRunnerOfName(const char*, const char*, const char* const*, int)
{
}
