// Reading a file of the host in one piece.
#pragma once

#include <string>

namespace openr_host {

// All bytes of the file.  Throws std::runtime_error "PATH: cannot be ..." when it cannot be read.
std::string ReadWholeFile(const std::string& path);

}  // namespace openr_host
