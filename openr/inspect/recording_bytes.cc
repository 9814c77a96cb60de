#include "openr/inspect/recording_bytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include "cli/input_file.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

[[noreturn]] void FailToRead(const std::string& file) {
  throw std::runtime_error(fmt::format("{}: cannot be read: {}", file, std::strerror(errno)));
}

}  // namespace

RecordingBytes::RecordingBytes(const std::string& file) {
  RequireReadable(file, kRecordingFile);
  struct stat facts {};
  if (stat(file.c_str(), &facts) != 0) FailToRead(file);
  if (!S_ISREG(facts.st_mode)) {
    std::optional<std::string> bytes = ReadFile(file);
    if (!bytes) FailToRead(file);
    part_ = std::move(*bytes);
    size_ = part_.size();
    return;
  }
  descriptor_ = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  // Reads the size of the open file, not of the file that is at this path now, because another run
  // may have put a new file there meanwhile.
  if (descriptor_ < 0 || fstat(descriptor_, &facts) != 0) FailToRead(file);
  size_ = static_cast<uint64_t>(facts.st_size);
}

RecordingBytes::~RecordingBytes() {
  if (descriptor_ >= 0) close(descriptor_);
}

// Uses pread() with an offset of its own, because all processes of a session of openr replay --step
// share the offset of the open file.
std::string_view RecordingBytes::Read(uint64_t at, uint64_t count) {
  count = at > size_ ? 0 : std::min(count, size_ - at);
  if (descriptor_ < 0) return std::string_view(part_).substr(at, count);
  part_.resize(count);
  uint64_t done = 0;
  while (done < count) {
    const ssize_t read =
        pread(descriptor_, part_.data() + done, count - done, static_cast<off_t>(at + done));
    if (read < 0 && errno == EINTR) continue;
    if (read < 0) error_ = errno;
    if (read <= 0) break;
    done += static_cast<uint64_t>(read);
  }
  return std::string_view(part_).substr(0, done);
}

}  // namespace openr_host
