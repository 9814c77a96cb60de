// Reads files of the host: whole, or piece by piece.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace openr_host {

// Whole files are read only up to this size.  A larger file is a mistake, or has no end,
// such as /dev/zero.
inline constexpr size_t kWholeFileMax = size_t{1} << 30;

// Returns the bytes of the file `path`.  If the file cannot be read to its end, returns nullopt and
// sets errno.  For a folder, errno is EISDIR; for a file of more than `bytes_max` bytes, EFBIG.
std::optional<std::string> ReadFile(const std::string& path, size_t bytes_max = kWholeFileMax);

// Returns the bytes of the file `path`.  If the file cannot be read, throws std::runtime_error with
// the text "PATH: the system's reason".
std::string ReadFileOrThrow(const std::string& path);

// Reads a file from its beginning, piece by piece.  Used if a file may be larger than the memory of
// the host, or if only the beginning of a file is needed.
class FileReader {
 public:
  // Opens the file `path`.  If that fails, is_open() is false, and errno is set.
  explicit FileReader(const std::string& path);
  ~FileReader();
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;

  bool is_open() const { return descriptor_ >= 0; }

  // Replaces `*piece` by the next `bytes_max` bytes of the file, or by fewer if the file ends
  // before.  Returns false with errno set if reading fails.  REQUIRES: is_open().
  bool Read(size_t bytes_max, std::string* piece);

 private:
  const int descriptor_;
};

}  // namespace openr_host
