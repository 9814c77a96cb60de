// The command line of this process, as it was typed.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// Returns the words of the command line, the program's name first.
std::vector<std::string> ProcessArguments();

}  // namespace openr_host
