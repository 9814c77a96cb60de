// The script by which a shell completes the words of a command line.
#pragma once

#include <string>

#include "openr/commands/command_tree.h"

namespace openr_host {

// Returns a script for bash that completes commands, flags, and the values of flags.  Such a value
// is a word of a list, a file or a folder.
std::string BashCompletion(const CommandInfo& program);

}  // namespace openr_host
