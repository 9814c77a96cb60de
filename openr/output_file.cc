#include "openr/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace openr_host {

namespace fs = std::filesystem;

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

std::string WhyNoFolder(const std::string& folder) {
  if (folder.empty()) return "'' names no folder";
  std::error_code error;
  fs::path there = fs::absolute(folder, error).lexically_normal();  // what there is of it
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_directory(there, error)) {
    return fs::equivalent(there, folder, error)
               ? fmt::format("{}: is a file; name a folder", folder)
               : fmt::format("{}: {} is a file, so nothing can be in it; name another folder",
                             folder, there.string());
  }
  if (access(there.c_str(), W_OK | X_OK) == 0) return "";
  return fmt::format("{}: you may not write in {}; name another folder", folder, there.string());
}

std::string Explain(const fs::filesystem_error& error) {
  const fs::path& path = error.path2().empty() ? error.path1() : error.path2();
  const char* why = nullptr;
  switch (error.code().value()) {
    case ENOENT:
      why = "there is no such file or folder";
      break;
    case EEXIST:
      why = "is there already";
      break;
    case ENOTDIR:
      why = "a part of this name is a file, where a folder has to be; name another place";
      break;
    case EISDIR:
      why = "is a folder, where a file has to be";
      break;
    case EACCES:
    case EPERM:
      why = "you may not read or write there";
      break;
    case EROFS:
      why = "cannot be written: this disk is read-only";
      break;
    case ENOSPC:
    case EDQUOT:
      why = "no room is left on the disk";
      break;
    default:
      return fmt::format("{}: {}", path.string(), error.code().message());
  }
  return fmt::format("{}: {}", path.string(), why);
}

std::string WriteFile(const std::string& file, const std::string& text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  return stream ? "" : Because(file, errno);
}

}  // namespace openr_host
