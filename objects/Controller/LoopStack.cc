//
// LoopStack for the robot, which has one stack for each object and no more.
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
