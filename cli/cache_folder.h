// The folder for files that the program can make again if they are lost, such as its copy of the
// default stick.
#pragma once

#include <filesystem>

namespace openr_host {

// Returns $XDG_CACHE_HOME/openr-host; without this variable $HOME/.cache/openr-host; without both
// variables a folder for temporary files.  The folder may not exist yet.
std::filesystem::path CacheFolder();

}  // namespace openr_host
