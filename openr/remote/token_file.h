// The file with the token of a server that other computers reach (openr run --listen).
#pragma once

#include <cstddef>
#include <string>

namespace openr::remote {

constexpr size_t kTokenMin = 16;
constexpr size_t kTokenMax = 128;

// Returns the token in a file: its first line, kTokenMin to kTokenMax letters, digits, '-' and '_'.
// Throws std::runtime_error if the file cannot be read or has no token, or if other users of this
// computer may read it.
std::string ReadTokenFile(const std::string& file);

}  // namespace openr::remote
