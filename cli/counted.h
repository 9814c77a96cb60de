// Numbers of things, for messages: "1 error", "2 errors".
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace openr_host {

// `count` and the noun, with an s unless there is one.
inline std::string Counted(uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace openr_host
