// Where the program keeps what it may need again.
#pragma once

#include <filesystem>

namespace openr_host {

// $XDG_CACHE_HOME/openr-host, ~/.cache/openr-host, or a temporary folder; it need not be there.
std::filesystem::path CacheFolder();

}  // namespace openr_host
