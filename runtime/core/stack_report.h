// Reports handlers that use more stack than the .ocf file (the settings) of their object gives.
//
// On the robot a stack that is too small overwrites other memory, and nothing reports it
// (field-notes.md, 3.7).  Stack frames of a 64-bit host are at most twice as large as the robot's.
// So only a handler that uses more than twice the size here surely overflows on the robot.
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
