// Describes where a benchmark ran, because its figures hold only there.
#pragma once

#include <string>

namespace openr_host {

struct Machine {
  // The next four are from /proc/cpuinfo, such as "AMD EPYC", "25", "17" and "1"; "unknown" if they
  // are not there.  The name alone is not enough, because processors of several families have it.
  std::string processor, family, model, stepping;
  std::string vectors;      // the widest vector instructions, such as "avx512f"
  unsigned processors = 0;  // number of processors
  double load = 0;          // mean number of running programs in the last minute; -1: unknown
  std::string compiler, c_library;
  std::string commit;  // value of the environment variable OPENR_COMMIT, or "unknown"
};

// Describes this machine as it is now.
Machine DescribeMachine();

// Returns `machine` in two lines for people.
std::string TextOf(const Machine& machine);

// The next functions return the compiler of this program, such as "g++ 12.2.0", and its C library,
// such as "glibc 2.36".
std::string CompilerName();
std::string CLibraryName();
// Returns the instructions for which xxHash and the C library choose their functions, such as
// "x86_64 with AVX2".  Counts of executed instructions depend on this choice.
std::string InstructionSet();

}  // namespace openr_host
