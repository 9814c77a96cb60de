// Writes the numbers of things with their nouns, for messages: "1 error", "2 errors".
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace openr_host {

// Returns `count` and the noun, with an s unless `count` is 1.
inline std::string Counted(uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace openr_host
