// Tools that a program may run under: Valgrind and AddressSanitizer.
#pragma once

#include <cstdlib>
#include <cstring>

namespace openr_host {

// Valgrind loads a library of its own into the program first.  Asking Valgrind itself would need
// headers that this may have been built without.
inline bool IsUnderValgrind() {
  static const bool is_under_valgrind = [] {
    const char* const preloaded = std::getenv("LD_PRELOAD");
    return preloaded != nullptr && std::strstr(preloaded, "vgpreload") != nullptr;
  }();
  return is_under_valgrind;
}

// AddressSanitizer and Valgrind take what lies below the stack pointer for memory of nobody: it
// must not be read or cleared then.
inline bool IsStackWatched() {
#if defined(__SANITIZE_ADDRESS__)
  return true;
#else
  return IsUnderValgrind();
#endif
}

}  // namespace openr_host
