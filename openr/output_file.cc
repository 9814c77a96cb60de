#include "openr/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace openr_host {
namespace {

std::string Because(const std::string& file, int error) {
  if (error == ENOENT) return fmt::format("{}: cannot be written: there is no such folder", file);
  return fmt::format("{}: cannot be written: {}", file, std::strerror(error));
}

}  // namespace

std::string WhyNotWritable(const std::string& file) {
  struct stat status;
  if (stat(file.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) return fmt::format("{}: is a folder; name a file", file);
    return access(file.c_str(), W_OK) == 0 ? "" : Because(file, errno);
  }
  // Only making it tells for sure.  EEXIST: a link to a file that is not there yet.
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno == EEXIST ? "" : Because(file, errno);
  close(descriptor);
  unlink(file.c_str());
  return "";
}

std::string WriteFile(const std::string& file, const std::string& text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  return stream ? "" : Because(file, errno);
}

}  // namespace openr_host
