// kUnsetCommand: the first word of each command in a new command vector.  The word stays until the
// program sets the command.
//
// On the robot a new vector holds the bytes that the memory held before.  So joints whose commands
// are not set shiver or move to extreme positions (field-notes.md, 7.5).  Here the first word is a
// number that no program sends on purpose.  So the host can distinguish a command that was never
// set from a command of 0, and report the unset command.
#pragma once

#include <OPENR/formats/commands.h>

namespace openr_host {

inline constexpr slongword kUnsetCommand = 0x6b6b6b6b;

}  // namespace openr_host
