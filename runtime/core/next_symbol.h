// The C library's own version of a function that this library defines as well.
#pragma once

#include <dlfcn.h>

namespace openr_host {

template <typename Function>
Function* NextSymbol(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace openr_host
