// Manual pages of the commands, for `man openr-run`.
#pragma once

#include <string>

#include "openr/commands/command_tree.h"

namespace openr_host {

// Returns the text of a manual page in the language of man(7).  The page of the program lists all
// commands.  The page of a command also describes its subcommands.  `version` is the version of the
// program.
std::string ManPage(const CommandInfo& program, const CommandInfo& command,
                    const std::string& version);

// Returns the name of the file for the manual page of a command, such as "openr-run.1".
std::string ManPageFile(const CommandInfo& command);

}  // namespace openr_host
