// The compile_commands.json of a build, from which editors and tools such as clangd learn how the
// user's sources are compiled.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "kit/kit_log.h"
#include "kit/source_copies.h"

namespace openr_host {

// Returns the text of the file: one command for each compiled source of the user.  The commands
// name the user's files.  Their flags also have the folders of the private copies, because headers
// that a build makes, such as def.h, are in no other folder.
std::string CompileDatabase(const KitLog& log, const std::vector<SourceCopy>& copies);

// Writes the file compile_commands.json into `folder`.  Adds the error to `problems` if that is not
// possible.
void WriteCompileDatabase(const std::filesystem::path& folder, const KitLog& log,
                          const std::vector<SourceCopy>& copies,
                          std::vector<std::string>* problems);

}  // namespace openr_host
