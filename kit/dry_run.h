// Tells whether a dry run of make (make -n), which should only print commands, would run commands.
#pragma once

#include <string>

namespace openr_host {

// Returns whether make runs commands of these Makefiles even in a dry run.  `makefiles` is the text
// of all Makefiles of a project.  make does so in three cases:
//   - a recipe line with $(MAKE) or ${MAKE} runs as a whole;
//   - a recipe line with the prefix '+' runs;
//   - a file that a Makefile includes, or the Makefile itself, is made by its rule.
// The result is also true if the text does not show which file is included, or if the file has no
// name of a Makefile (text_files.h), because its text is then not in `makefiles`.  Calls of
// $(shell) do not count, because make runs them whenever it reads the Makefile, not only in a dry
// run.
bool DryRunRunsCommands(const std::string& makefiles);

}  // namespace openr_host
