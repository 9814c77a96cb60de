// ASSERT: our own mistakes, checked in every build.
//
// Prints the condition, the values given and where the run stood (virtual time,
// object, message, seed), then aborts.
#pragma once

#include <fmt/format.h>

#include <string>

namespace openr_host {

[[noreturn]] void AssertFailed(const char* file, int line, const char* condition,
                               const std::string& details);

// The function that returns where the run stood, as lines of text with their ends; null: no run.
// It also ends the code of the object under way, because abort() would end only its method.
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
