// The file with the token, the secret that a server (openr run --listen) asks of clients on other
// computers.
#pragma once

#include <cstddef>
#include <string>

namespace openr::remote {

constexpr size_t kTokenMin = 16;
constexpr size_t kTokenMax = 128;

// Returns the token, a secret, in a file: its first line, kTokenMin to kTokenMax letters, digits,
// '-' and '_'.  Throws std::runtime_error if the file cannot be read or has no token, or if other
// users of this computer may read it.
std::string ReadTokenFile(const std::string& file);

}  // namespace openr::remote
