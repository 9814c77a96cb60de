// The compiler's flags of Makefiles, for objects that are built without their Makefile.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "kit/kit_log.h"
#include "kit/make_build.h"

namespace openr_host {

// The flags (-D, -I, -std ...) with which Makefiles compile the sources of `folder`, each once: as
// the compilers of a build wrote them to `log`, or else as the variables of the Makefile in
// `folder` say.  `variables`: what make gets on its command line.
std::vector<std::string> FlagsOfMakefiles(
    const std::filesystem::path& folder, const KitLog& log,
    const std::vector<std::pair<std::string, std::string>>& variables, const MakeOptions& options);

}  // namespace openr_host
