// Refuses functions of the C library that do not exist on the robot.
#pragma once

#include "runtime/hooks/hook.h"

namespace openr_host {

// Returns whether code of an object has called the function `name`.  If so, adds a finding with the
// reason `why` and sets errno to ENOSYS, because the call must fail.
bool Refuses(
    const char* name,
    const char* why = "there is no such thing on the robot (Programmer's Guide, appendix A)");

}  // namespace openr_host

// Defines the C library's function `name` once more.  If an object calls the new function, the
// function adds a finding and returns `failure`.  For other callers, the new function calls the C
// library's function.
#define OPENR_REFUSE(type, name, failure, parameters, arguments) \
  OPENR_REFUSE_FOR(type, name, name, failure, parameters, arguments)

// Does the same, but calls the C library's function `other` for other callers.
#define OPENR_REFUSE_FOR(type, name, other, failure, parameters, arguments) \
  extern "C" type name parameters {                                         \
    static const auto next = OPENR_NEXT(other);                             \
    return openr_host::Refuses(#name) ? failure : next arguments;           \
  }
