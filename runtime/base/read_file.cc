#include "runtime/base/read_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace openr_host {
namespace {

// Reads the open file `descriptor` to its end and appends the bytes to `*bytes`.  Returns false
// with errno set if reading fails.
bool ReadRest(int descriptor, std::string* bytes) {
  char block[65536];
  for (;;) {
    const ssize_t count = read(descriptor, block, sizeof block);
    if (count == 0) return true;
    if (count > 0) {
      bytes->append(block, static_cast<size_t>(count));
    } else if (errno != EINTR) {
      return false;
    }
  }
}

}  // namespace

std::optional<std::string> ReadFile(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  std::string bytes;
  const bool is_whole = ReadRest(descriptor, &bytes);
  const int error = errno;
  close(descriptor);
  errno = error;  // the errno of ReadRest(), for the caller: close() may have changed it
  if (!is_whole) return std::nullopt;
  return bytes;
}

std::string ReadFileOrThrow(const std::string& path) {
  std::optional<std::string> bytes = ReadFile(path);
  if (!bytes) throw std::runtime_error(fmt::format("{}: {}", path, std::strerror(errno)));
  return *std::move(bytes);
}

}  // namespace openr_host
