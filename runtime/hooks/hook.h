// What the functions of the C library that this library defines have in common.
//
// They are found before those of the C library by every caller in the process.  They act only while
// code of an image runs, and call the C library's own version otherwise.  docs/hooks.md lists them.
#pragma once

#include <dlfcn.h>

#include "runtime/core/current.h"
#include "runtime/core/object.h"

namespace openr_host {

// Whether code of an image makes the call, and not the runtime on its behalf.
inline bool InObject() { return t_current.image_code && t_current.object != nullptr; }

// The C library's own version of a function that this library defines as well.
template <typename Function>
Function* NextSymbol(const char* name) {
  const LibraryScope scope;
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace openr_host

// The same, with the type that its declaration has.
#define OPENR_NEXT(name) \
  (static_cast<decltype(&name)>(openr_host::NextSymbol<decltype(name)>(#name)))
