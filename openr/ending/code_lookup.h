// Finds functions and lines of instructions, by the debug information of images.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// The function and line of an instruction; "" for parts that are not known.
struct CodeLookup {
  std::string function;  // "Trouble::DoStart(OSystemEvent const&)"
  std::string line;      // "Trouble.cc:57"
};

// Looks up the instruction at `offset` of a loaded ELF file.  The debug information is in the file,
// or beside it in a file that it names (NAME.DBG).
CodeLookup LookUpCode(const char* file, uintptr_t offset);

// Returns the line of an instruction in memory; "" if it is not known.
std::string LineOfAddress(const void* address);

}  // namespace openr_host
