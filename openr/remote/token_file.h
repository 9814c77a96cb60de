// The file with the token, the secret that a server (openr run --listen) asks of clients on other
// computers.
#pragma once

#include <cstddef>
#include <string>

namespace openr::remote {

constexpr size_t kTokenMin = 16;
constexpr size_t kTokenMax = 128;

// Reads the token, the secret of a server, from `file`.  The token is the first line of the file:
// kTokenMin to kTokenMax letters, digits, '-' and '_'.  Throws std::runtime_error if the file
// cannot be read or has no token, or if other users of this computer may read the file.
std::string ReadTokenFile(const std::string& file);

}  // namespace openr::remote
