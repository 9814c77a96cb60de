// What the commands of a fresh vector hold until somebody fills them in.
//
// On the robot it is whatever the memory held before: joints shiver or go to extremes
// (field-notes.md, 7.5).  Here the first word of every command is a number that no program
// means, so that a command nobody filled in can be told from one that says 0.
#pragma once

#include <OPENR/formats/commands.h>

namespace openr_host {

inline constexpr slongword kNeverFilled = 0x6b6b6b6b;

}  // namespace openr_host
