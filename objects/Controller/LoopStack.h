//
// A second stack for controller programs that are an endless loop (ControllerPort::RunLoop).  The
// program can leave this stack in the middle of the loop, so that the object's method returns, and
// continue there later.
//
// OPEN-R gives an object only one stack, and an object whose method does not return handles no more
// messages (Hohl 2004, 5.3.3).  So there are two implementations, from which the build chooses:
// LoopStack.cc for the robot has no second stack, so robot_step() ends such a program there.
// kit/controller/LoopStack.cc for the host has a second stack.
//

#ifndef LoopStack_h_DEFINED
#define LoopStack_h_DEFINED

// Calls body(argument), on the second stack if there is one.  Returns when `body` has ended or has
// called LoopStackLeave().
void LoopStackRun(void (*body)(void*), void* argument);

// Called by the function that runs on the second stack, to leave this stack: LoopStackRun() or
// LoopStackContinue() then returns.  Returns true when the function is continued.  Returns false at
// once when there is no second stack.
bool LoopStackLeave();

// Continues the function that runs on the second stack: its last call of LoopStackLeave() returns
// true.  Returns when the function has ended or has called LoopStackLeave() again.  REQUIRES: the
// function has called LoopStackLeave() and has not been continued since.
void LoopStackContinue();

// Adds `text`, which describes a mistake of the controller program, to the findings of the run on a
// host.  Does nothing on the robot.
void TellRunner(const char* text);

// Adds `text` to the findings as TellRunner() does.  `text` says that `name` is none of the `count`
// names in `known`.  The host adds the known name that was probably meant.
void TellRunnerOfName(const char* text, const char* name, const char* const* known, int count);

#endif  // LoopStack_h_DEFINED
