#include "runtime/base/lazy_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace openr_host {

LazyLibrary::LazyLibrary(const char* file, const char* what, const char* package, bool is_global)
    : file_(file), handle_(dlopen(file, RTLD_NOW | (is_global ? RTLD_GLOBAL : RTLD_LOCAL))) {
  if (handle_ != nullptr) return;
  throw std::runtime_error(fmt::format("{} cannot be loaded: {}; install it (Debian package {})",
                                       what, dlerror(), package));
}

void* LazyLibrary::Address(const char* name) const {
  void* const address = dlsym(handle_, name);
  if (address != nullptr) return address;
  throw std::runtime_error(fmt::format(
      "{} is another version than the one with which this program was built: it has no {}()", file_,
      name));
}

}  // namespace openr_host
