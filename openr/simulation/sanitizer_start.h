// Starts the program again with the library of AddressSanitizer, if images need it.
#pragma once

#include <string>

namespace openr_host {

// Returns the path of the library of AddressSanitizer if this process does not have it and an image
// on the stick in the folder `stick` needs it, because it was built with openr build --sanitize;
// otherwise "".  `stick` "" is the default stick, whose images do not need the library.
std::string MissingSanitizer(const std::string& stick);

// If MissingSanitizer() returns a library for the stick, replaces this process by the same program
// with the same arguments, and makes the dynamic linker load this library first.  The library must
// come before all others, because it replaces malloc().  Returns if no library is missing.  Throws
// std::runtime_error if the library cannot be loaded.
void StartWithSanitizerOf(const std::string& stick);

}  // namespace openr_host
