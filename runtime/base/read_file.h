// Functions that read a whole file of the host.
#pragma once

#include <optional>
#include <string>

namespace openr_host {

// Returns the bytes of the file `path`.  If the file cannot be read to its end, returns nullopt and
// sets errno.  For a folder, errno is EISDIR.
std::optional<std::string> ReadFile(const std::string& path);

// Returns the bytes of the file `path`.  If the file cannot be read, throws std::runtime_error with
// the text "PATH: the system's reason".
std::string ReadFileOrThrow(const std::string& path);

}  // namespace openr_host
