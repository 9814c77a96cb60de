// Assembly for the robot's processor inside of C and C++: what a host compiler cannot translate.
//
// A statement becomes a trap, so that the rest of the object builds and runs.  One that only waits
// or orders memory accesses (nop, sync) becomes a barrier.  Lines never move.
#pragma once

#include <string>
#include <vector>

#include "kit/repair_rules.h"

namespace openr_host {

// Whether `complaint` is about assembly: of the compiler ("... in 'asm'") or of the assembler.
bool IsAboutAssembly(const Complaint& complaint);

// Prefix of the message of a complaint that the assembler made.
inline constexpr char kAssemblerSays[] = "assembler: ";

// The edits that answer such a complaint about `text`.  A complaint without a line is about the
// statements outside of functions.
std::vector<Edit> AssemblyRepairOf(const Complaint& complaint, const std::string& text);

// The edits of the macros of `header` that hold assembly and are used in `line`, a line of a
// source.
std::vector<Edit> AssemblyMacroRepairOf(const std::string& line, const std::string& header);

}  // namespace openr_host
