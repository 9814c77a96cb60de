// Describes where a benchmark ran, because its figures hold only there.
#pragma once

#include <string>

namespace openr_host {

// Returns the processor's name from /proc/cpuinfo, such as "AMD EPYC", or "unknown".
std::string ProcessorName();
// The next functions return the compiler of this program, such as "g++ 12.2.0", and its C library,
// such as "glibc 2.36".
std::string CompilerName();
std::string CLibraryName();
// Returns the instructions for which xxHash and the C library choose their functions, such as
// "x86_64 with AVX2".  Counts of executed instructions depend on this choice.
std::string InstructionSet();

}  // namespace openr_host
