// Reads files of the host.
#pragma once

#include <optional>
#include <string>

namespace openr_host {

// Returns the bytes of the file `path`, or nullopt with errno set if it cannot be read to its end.
// Reading a folder fails with EISDIR.
std::optional<std::string> ReadFile(const std::string& path);

// Throws std::runtime_error "PATH: the system's reason" instead.
std::string ReadFileOrThrow(const std::string& path);

}  // namespace openr_host
