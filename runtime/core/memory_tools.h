// Finds out under which memory checker this program runs: Valgrind or AddressSanitizer.
//
// AddressSanitizer is in this program (./dev sanitize), or only in the images that this program
// runs (openr build --sanitize).  In the second case the library of AddressSanitizer was preloaded,
// and the weak declarations below find its functions.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>

extern "C" {
[[gnu::weak]] void __asan_init();
[[gnu::weak]] void __asan_unpoison_memory_region(const volatile void* address, size_t bytes);
[[gnu::weak]] void __asan_set_error_report_callback(void (*callback)(const char* report));
[[gnu::weak]] void __sanitizer_start_switch_fiber(void** saved, const void* bottom, size_t bytes);
[[gnu::weak]] void __sanitizer_finish_switch_fiber(void* saved, const void** bottom, size_t* bytes);
}

namespace openr_host {

// Returns whether the program runs under Valgrind: whether LD_PRELOAD has the library that Valgrind
// adds.  Valgrind's macro for this question is not used, because its header is not installed
// everywhere.
inline bool IsUnderValgrind() {
  static const bool is_under_valgrind = [] {
    const char* const preloaded = std::getenv("LD_PRELOAD");
    return preloaded != nullptr && std::strstr(preloaded, "vgpreload") != nullptr;
  }();
  return is_under_valgrind;
}

// Returns whether AddressSanitizer is in this process.
inline bool IsAddressSanitized() {
#if defined(__SANITIZE_ADDRESS__)
  return true;
#else
  return &__asan_init != nullptr;
#endif
}

// Returns whether a tool watches the stack.  AddressSanitizer and Valgrind report accesses to
// memory below the stack pointer, so with these tools that memory must not be read or cleared.
inline bool IsStackWatched() { return IsAddressSanitized() || IsUnderValgrind(); }

}  // namespace openr_host
