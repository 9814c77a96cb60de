// Reports handlers that use more stack than the .ocf file (the settings) of their object gives.
//
// On the robot a stack that is too small overwrites other memory, and nothing reports it
// (field-notes.md, 3.7).  On the 64-bit host, stack frames are at most twice as large as on the
// robot.  So a handler surely overflows its stack on the robot only if it uses, on the host, more
// than twice the stack size that the .ocf file gives.
#pragma once

#include <cstddef>

namespace openr_host {

class Object;
class System;

// Records that a handler of `object` has used `bytes` of stack.  With --strict, if this is more
// than twice the size in the .ocf file, adds an error finding and stops the robot.
void NoteStackUse(Object* object, size_t bytes);

// Adds a warning for every object with a handler that used more stack than the .ocf file gives.
// Called at the end of a run.
void ReportStacks(System* system);

}  // namespace openr_host
