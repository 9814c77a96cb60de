#include "cli/copy_file.h"

#include <sys/statvfs.h>

namespace openr_host {

namespace fs = std::filesystem;

std::error_code TryCopyFile(const fs::path& from, const fs::path& to, fs::copy_options options) {
  std::error_code error, ignored;
  const bool is_new = !fs::exists(to, ignored);
  fs::copy_file(from, to, options, error);
  if (!error) return error;
  // Tests whether the disk is full before the incomplete copy is removed, because removing the copy
  // makes room, and the disk would then not look full.
  struct statvfs disk {};
  if (error == std::errc::io_error && statvfs(to.c_str(), &disk) == 0 && disk.f_bavail == 0)
    error = std::make_error_code(std::errc::no_space_on_device);
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
