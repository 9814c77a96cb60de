// Finds the function and the source line of a machine instruction, by the debug information of the
// file that contains the instruction.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// The function and the source line that a machine instruction belongs to.  A field is "" if the
// debug information does not have it.
struct CodeLookup {
  std::string function;  // name of the function, such as "Trouble::DoStart(OSystemEvent const&)"
  std::string line;      // file and line, such as "Trouble.cc:57"
};

// Looks up the instruction at `offset` bytes from the address at which the ELF file `file`, a
// shared object, is loaded.  In a file that was linked for fixed addresses, `offset` is the
// address.  The debug information is read from `file` itself, or from the file beside it that
// `file` names (NAME.DBG).
CodeLookup LookUpCode(const char* file, uintptr_t offset);

// Returns the source line of the machine instruction at `address` in memory; "" if the line is not
// known.
std::string LineOfAddress(const void* address);

}  // namespace openr_host
