// The script by which a shell completes the words of a command line.
#pragma once

#include <string>

#include "openr/commands/command_tree.h"

namespace openr_host {

// Returns a script for bash that completes commands, flags, and values of flags: the words of a
// list, files, folders.
std::string BashCompletion(const CommandInfo& program);

}  // namespace openr_host
