// Functions that all hooks use.  A hook is a function of the C library that the folder
// runtime/hooks defines once more.
//
// A call from anywhere in the process goes to the hook instead of the function of the C library.  A
// hook acts only while code of an image runs; otherwise it calls the C library's function.
// docs/hooks.md lists the hooks.
#pragma once

#include <dlfcn.h>

#include "runtime/core/current.h"
#include "runtime/core/object.h"

namespace openr_host {

// Returns whether the caller of a hook (our version of a function of the C library) is code of an
// image (a program of the robot).  Returns false for code of the runtime, even while this code
// works for an object.
inline bool InObject() { return t_current.image_code && t_current.object != nullptr; }

// Returns the C library's function `name`.  The hook (our version of this function) calls it for
// callers that are not objects.
template <typename Function>
Function* NextSymbol(const char* name) {
  const LibraryScope scope;
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace openr_host

// Finds the C library's function `name`.  A header must declare this function, so that the caller
// need not write the function's type.
#define OPENR_NEXT(name) \
  (static_cast<decltype(&name)>(openr_host::NextSymbol<decltype(name)>(#name)))
