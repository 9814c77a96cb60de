// Functions and lines of instructions, from the debug information of images.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// Parts that the file and its debug information do not say are "".
struct CodeLookup {
  std::string function;  // "Trouble::DoStart(OSystemEvent const&)"
  std::string line;      // "Trouble.cc:57"
};

// The instruction at `offset` of a loaded ELF file.  Its debug information is in the file, or in
// one beside it that it names (NAME.DBG).
CodeLookup LookUpCode(const char* file, uintptr_t offset);

// The line of an instruction in memory; "" if it is not known.
std::string LineOfAddress(const void* address);

}  // namespace openr_host
