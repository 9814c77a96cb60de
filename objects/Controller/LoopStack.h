//
// A second stack, for controllers that are an endless loop (ControllerPort::RunLoop).
//
// OPEN-R has no second stacks, and an object whose method does not return is lost (Hohl 2004,
// 5.3.3).  So there are two implementations, from which the build chooses: LoopStack.cc for the
// robot, without a second stack, and that of the host's kit.
//

#ifndef LoopStack_h_DEFINED
#define LoopStack_h_DEFINED

// Calls body(argument), on the second stack if there is one.  Returns when body has ended or has
// called LoopStackLeave().
void LoopStackRun(void (*body)(void*), void* argument);

// Called by body.  Lets LoopStackRun() or LoopStackContinue() return, and returns true when body is
// continued.  Returns false at once when there is no second stack.
bool LoopStackLeave();

// Continues body after its LoopStackLeave().  Returns when body has ended or has called it again.
// REQUIRES: body has called LoopStackLeave() and was not continued since.
void LoopStackContinue();

// Reports a mistake of the controller outside of the robot's log, on a host in the list of
// findings.
void TellRunner(const char* text);

// Reports a name that is not one of the `count` known names.  The host adds the name that was
// probably meant.
void TellRunnerOfName(const char* text, const char* name, const char* const* known, int count);

#endif  // LoopStack_h_DEFINED
