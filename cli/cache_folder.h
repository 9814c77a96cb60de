// The folder for files that the program can make again, such as the copy of the default stick.
#pragma once

#include <filesystem>

namespace openr_host {

// Returns $XDG_CACHE_HOME/openr-host, else ~/.cache/openr-host, else a temporary folder.  The
// folder may not exist yet.
std::filesystem::path CacheFolder();

}  // namespace openr_host
