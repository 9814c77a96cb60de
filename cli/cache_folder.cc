#include "cli/cache_folder.h"

#include <cstdlib>

#include "runtime/base/temp_folder.h"

namespace openr_host {

namespace fs = std::filesystem;

fs::path CacheFolder() {
  if (const char* const cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache == '/')
    return fs::path(cache) / "openr-host";
  if (const char* const home = std::getenv("HOME"); home != nullptr && *home == '/')
    return fs::path(home) / ".cache" / "openr-host";
  return fs::path(TemporaryFiles()) / "openr-host-cache";
}

}  // namespace openr_host
