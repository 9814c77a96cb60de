#include "runtime/base/read_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

// Reads at most `size` bytes from `descriptor`.  If a signal interrupts the reading, tries again.
// Returns the number of bytes: 0 at the end of the file, and -1 with errno set if reading fails.
ssize_t ReadBlock(int descriptor, char* block, size_t size) {
  for (;;) {
    const ssize_t count = read(descriptor, block, size);
    if (count >= 0 || errno != EINTR) return count;
  }
}

// Reads the open file `descriptor` to its end and appends the bytes to `*bytes`.  Returns false
// with errno set if reading fails or the file has more than `bytes_max` bytes.
bool ReadRest(int descriptor, size_t bytes_max, std::string* bytes) {
  // Takes memory for the whole file at once.  If the text grew step by step, each step would use
  // new pages of memory, which takes longer than reading the file.  The size is only a hint:
  // special files have none, and a file may grow while it is read.
  struct stat status;
  if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) {
    const auto size = static_cast<size_t>(status.st_size);
    if (size > bytes_max) {
      errno = EFBIG;
      return false;
    }
    bytes->reserve(size);
  }
  char block[16384];
  for (;;) {
    const ssize_t count = ReadBlock(descriptor, block, sizeof block);
    if (count <= 0) return count == 0;
    if (static_cast<size_t>(count) > bytes_max - bytes->size()) {
      errno = EFBIG;
      return false;
    }
    bytes->append(block, static_cast<size_t>(count));
  }
}

}  // namespace

std::optional<std::string> ReadFile(const std::string& path, size_t bytes_max) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  std::string bytes;
  const bool is_whole = ReadRest(descriptor, bytes_max, &bytes);
  const int error = errno;
  close(descriptor);
  errno = error;  // gives the caller the errno of ReadRest(), which close() may have changed
  if (!is_whole) return std::nullopt;
  return bytes;
}

FileReader::FileReader(const std::string& path)
    : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}

FileReader::~FileReader() {
  if (is_open()) close(descriptor_);
}

bool FileReader::Read(size_t bytes_max, std::string* piece) {
  ASSERT(is_open());
  piece->resize(bytes_max);
  size_t size = 0;
  while (size < bytes_max) {
    const ssize_t count = ReadBlock(descriptor_, piece->data() + size, bytes_max - size);
    if (count < 0) return false;
    if (count == 0) break;
    size += static_cast<size_t>(count);
  }
  piece->resize(size);
  return true;
}

std::string ReadFileOrThrow(const std::string& path) {
  std::optional<std::string> bytes = ReadFile(path);
  if (!bytes) throw std::runtime_error(fmt::format("{}: {}", path, std::strerror(errno)));
  return *std::move(bytes);
}

}  // namespace openr_host
