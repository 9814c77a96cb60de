// Removes assembly for the robot's processor from C and C++ sources, because the host's compiler
// cannot translate such assembly.
//
// An assembly statement becomes a trap, which ends the run only if the program reaches the trap.
// So the rest of the object builds and runs.  A statement that only waits or orders memory accesses
// (nop, sync) becomes a barrier.  The edits keep all line numbers, so messages of the compiler name
// the right lines.
#pragma once

#include <string>
#include <vector>

#include "kit/repair_rules.h"

namespace openr_host {

// Returns whether the error message `error` is about assembly.  Such a message comes from the
// compiler ("... in 'asm'") or from the assembler.
bool IsAboutAssembly(const CompilerError& error);

// Beginning of CompilerError::message for errors that come from the assembler and not the compiler.
inline constexpr char kAssemblerSays[] = "assembler: ";

// Returns the edits that remove assembly from the source `text`: the asm statement that `error` is
// about or, if the error names no line, all assembly outside of functions.
std::vector<Edit> AssemblyRepairOf(const CompilerError& error, const std::string& text);

// Returns the edits that remove the assembly from macros in `header`, the text of a header.  `line`
// is the source line with the error.  Macros that this line does not use are not changed.
std::vector<Edit> AssemblyMacroRepairOf(const std::string& line, const std::string& header);

}  // namespace openr_host
