#include "cli/copy_file.h"

#include <sys/resource.h>
#include <sys/statvfs.h>

namespace openr_host {

namespace fs = std::filesystem;

namespace {

// Returns the reason why a copy of `from` to `to` has failed with an input/output error, before the
// incomplete copy is removed: removing it makes room, and the disk would then not look full.
std::error_code ReasonOfFailure(const fs::path& from, const fs::path& to) {
  struct statvfs disk {};
  if (statvfs(to.c_str(), &disk) == 0 && disk.f_bavail == 0)
    return std::make_error_code(std::errc::no_space_on_device);
  std::error_code error;
  const auto size = fs::file_size(from, error);
  rlimit limit;
  if (!error && getrlimit(RLIMIT_FSIZE, &limit) == 0 && size > limit.rlim_cur)
    return std::make_error_code(std::errc::file_too_large);
  return std::make_error_code(std::errc::io_error);
}

}  // namespace

std::error_code TryCopyFile(const fs::path& from, const fs::path& to, fs::copy_options options) {
  std::error_code error, ignored;
  const bool is_new = !fs::exists(to, ignored);
  fs::copy_file(from, to, options, error);
  if (!error) return error;
  if (error == std::errc::io_error) error = ReasonOfFailure(from, to);
  if (is_new) fs::remove(to, ignored);
  return error;
}

void CopyFile(const fs::path& from, const fs::path& to, fs::copy_options options) {
  const std::error_code error = TryCopyFile(from, to, options);
  if (error) throw fs::filesystem_error("cannot be copied", from, to, error);
}

void CopyFolder(const fs::path& from, const fs::path& to, fs::copy_options options) {
  fs::create_directory(to, from);
  for (const auto& entry : fs::directory_iterator(from)) {
    const fs::path copy = to / entry.path().filename();
    if (entry.is_directory()) {
      CopyFolder(entry.path(), copy, options);
    } else {
      CopyFile(entry.path(), copy, options);
    }
  }
}

}  // namespace openr_host
