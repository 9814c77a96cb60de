// Removes assembly for the robot's processor from C and C++ sources, because the host's compiler
// cannot translate it.
//
// An assembly statement becomes a trap, which ends the run only if it is reached, so that the rest
// of the object builds and runs.  A statement that only waits or orders memory accesses (nop, sync)
// becomes a barrier.  No line changes its number.
#pragma once

#include <string>
#include <vector>

#include "kit/repair_rules.h"

namespace openr_host {

// Returns whether `complaint` is about assembly.  Such a complaint comes from the compiler ("... in
// 'asm'") or from the assembler.
bool IsAboutAssembly(const Complaint& complaint);

// Prefix of the message of a complaint that the assembler made.
inline constexpr char kAssemblerSays[] = "assembler: ";

// Returns the edits of `text` that remove the assembly which `complaint` is about.  A complaint
// without a line is about the statements outside of functions.
std::vector<Edit> AssemblyRepairOf(const Complaint& complaint, const std::string& text);

// Returns the edits of `header` for those of its macros that contain assembly and are used in
// `line`, a line of a source.
std::vector<Edit> AssemblyMacroRepairOf(const std::string& line, const std::string& header);

}  // namespace openr_host
