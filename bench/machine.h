// Describes where a benchmark ran, because its figures hold only there.
#pragma once

#include <string>

namespace openr_host {

// "AMD EPYC": the processor's name from /proc/cpuinfo, or "unknown".
std::string ProcessorName();
// Return the compiler of this program, "g++ 12.2.0", and the C library that it uses, "glibc 2.36".
std::string CompilerName();
std::string CLibraryName();
// "x86_64 with AVX2": the instructions for which xxHash and the C library choose their functions.
// Counts of instructions depend on them.
std::string InstructionSet();

}  // namespace openr_host
