// Names of functions that a file does not export.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// The function at `offset` of an ELF file that is loaded, as in its source; "" when its table of
// symbols, which dladdr() does not read, is missing or does not say.
std::string FunctionName(const char* file, uintptr_t offset);

}  // namespace openr_host
