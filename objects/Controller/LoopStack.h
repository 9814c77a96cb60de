//
// A second stack, for controllers that are an endless loop (ControllerPort::RunLoop).
//
// OPEN-R has nothing of the kind: a method that does not return is the end of its object (Hohl
// 2004, 5.3.3).  So there are two implementations, and the build chooses: LoopStack.cc for the
// robot, which has no stack, and one of the host's kit.  This header is all that objects know.
//

#ifndef LoopStack_h_DEFINED
#define LoopStack_h_DEFINED

// Calls body(argument), on the second stack if there is one; returns when it has ended or left.
void LoopStackRun(void (*body)(void*), void* argument);

// Called by body: back to LoopStackRun() or LoopStackContinue(), and true when continued.  False,
// at once, when there is no second stack.
bool LoopStackLeave();

// REQUIRES: body has left.
void LoopStackContinue();

// Tells whoever runs the robot, beyond its log, what the controller should not do.
void TellRunner(const char* text);

// The same about a name that is none of the `count` known ones, for whoever can tell which was meant.
void TellRunnerOfName(const char* text, const char* name, const char* const* known, int count);

#endif  // LoopStack_h_DEFINED
