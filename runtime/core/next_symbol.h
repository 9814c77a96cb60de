// The C library's own version of a function that this library defines as well.
#pragma once

#include <dlfcn.h>

#include "runtime/core/current.h"

namespace openr_host {

// Looking it up takes more stack than an object may have.
template <typename Function>
Function* NextSymbol(const char* name) {
  const LibraryScope scope;
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace openr_host
