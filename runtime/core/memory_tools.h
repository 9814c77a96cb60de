// Finds out under which memory checker this program runs: Valgrind or AddressSanitizer.
#pragma once

#include <cstdlib>
#include <cstring>

namespace openr_host {

// Returns whether the program runs under Valgrind, which adds a library of its own to LD_PRELOAD.
// Valgrind's own macro for this is in a header that is not installed everywhere.
inline bool IsUnderValgrind() {
  static const bool is_under_valgrind = [] {
    const char* const preloaded = std::getenv("LD_PRELOAD");
    return preloaded != nullptr && std::strstr(preloaded, "vgpreload") != nullptr;
  }();
  return is_under_valgrind;
}

// Returns whether a tool watches the stack.  AddressSanitizer and Valgrind report accesses to
// memory below the stack pointer, so with these tools that memory must not be read or cleared.
inline bool IsStackWatched() {
#if defined(__SANITIZE_ADDRESS__)
  return true;
#else
  return IsUnderValgrind();
#endif
}

}  // namespace openr_host
