// Finds the compiler flags that Makefiles use, for objects that are built without their Makefile.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "kit/kit_log.h"
#include "kit/make_build.h"

namespace openr_host {

// Returns the flags (-D, -I, -std ...) with which Makefiles compile the sources of `folder`, each
// once.  The flags come from `log`, where the compiler has recorded its flags during make.  If the
// log has no flags, they come from the variables of the Makefile in `folder`.  `variables` are set
// on the command line of make.
std::vector<std::string> FlagsOfMakefiles(
    const std::filesystem::path& folder, const KitLog& log,
    const std::vector<std::pair<std::string, std::string>>& variables, const MakeOptions& options);

}  // namespace openr_host
