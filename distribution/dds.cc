#include "distribution/dds.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace openr_host {
namespace {

DdsFunctions Load() {
  // The symbols are global, because the security plugins of Cyclone DDS may need them.
  void* const library = dlopen(OPENR_DDS_LIBRARY, RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr) {
    throw std::runtime_error(fmt::format(
        "Cyclone DDS, by which processes exchange data, cannot be loaded: {}; install it (Debian "
        "package libddsc0debian)",
        dlerror()));
  }
  const auto find = [library]<typename T>(T* function, const char* name) {
    *function = reinterpret_cast<T>(dlsym(library, name));
    if (*function == nullptr) {
      throw std::runtime_error(fmt::format(
          "{} is another version than the one with which this program was built: it has no {}()",
          OPENR_DDS_LIBRARY, name));
    }
  };
  DdsFunctions functions;
#define OPENR_DDS_FIND(name) find(&functions.name, #name);
  OPENR_DDS_FUNCTIONS(OPENR_DDS_FIND)
#undef OPENR_DDS_FIND
  return functions;
}

}  // namespace

const DdsFunctions& Dds() {
  static const DdsFunctions functions = Load();
  return functions;
}

}  // namespace openr_host
