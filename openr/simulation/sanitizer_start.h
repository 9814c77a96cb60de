// Starts the program again with the library of AddressSanitizer, if images need it.
#pragma once

#include <string>

namespace openr_host {

// If an image on the stick in the folder `stick` was built with openr build --sanitize, replaces
// this process by the same program with the same arguments, into which the library of
// AddressSanitizer is loaded first.  The library must come before all others, because it replaces
// malloc().  Returns if no image needs it, or if the process has it.  `stick` "" is the default
// stick, whose images do not need it.  Throws std::runtime_error if the library cannot be loaded.
void StartWithSanitizerOf(const std::string& stick);

}  // namespace openr_host
