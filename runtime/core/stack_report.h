// Findings about the stack that handlers use, beside the size that the .ocf file gives.
//
// On the robot a stack that is too small overwrites other memory without a word (field-notes.md,
// 3.7).  Frames of a 64-bit host are at most twice as large as the robot's, so only what takes
// twice the size here surely overflows there.
#pragma once

#include <cstddef>

namespace openr_host {

class Object;
class System;

// A handler of `object` has used so many bytes.  With --strict, more than twice the size of the
// .ocf file is an error finding and stops the robot.
void NoteStackUse(Object* object, size_t bytes);

// At the end of a run: a warning for every object whose handlers used more than the .ocf file
// gives.
void ReportStacks(System* system);

}  // namespace openr_host
