// ASSERT: checks, in release builds too, a condition that only a mistake in our own code can break.
//
// A failed ASSERT prints the condition, the values given and the state of the run (virtual time,
// object, message, seed), then aborts.
#pragma once

#include <fmt/format.h>

#include <string>

namespace openr_host {

[[noreturn]] void AssertFailed(const char* file, int line, const char* condition,
                               const std::string& details);

// The function that AssertFailed() calls before abort(); null until the first System is made.
// Returns the state of the run (virtual time, object, message, seed) as lines of text, each with
// its newline.  Also clears t_current (current.h).  While t_current names an object, abort() ends
// only the handler and not the process (runtime/hooks).
extern std::string (*assert_context)();

}  // namespace openr_host

#define ASSERT(condition, ...)                                              \
  do {                                                                      \
    if (!(condition)) [[unlikely]] {                                        \
      ::openr_host::AssertFailed(__FILE__, __LINE__, #condition,            \
                                 ::openr_host::AssertDetails(__VA_ARGS__)); \
    }                                                                       \
  } while (false)

namespace openr_host {

inline std::string AssertDetails() { return {}; }
template <typename... Args>
std::string AssertDetails(fmt::format_string<Args...> format, Args&&... args) {
  return fmt::format(format, std::forward<Args>(args)...);
}

}  // namespace openr_host
