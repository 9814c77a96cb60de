#include "runtime/core/run_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "runtime/base/hasher.h"

namespace openr_host {

namespace fs = std::filesystem;

namespace {

bool Write(const std::string& path, const std::string& bytes) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  return stream.good();
}

std::string CannotCopyTo(const std::string& path) {
  return fmt::format("cannot be copied to {}: {} (TMPDIR chooses another folder)", path,
                     std::strerror(errno));
}

// Returns the path of the file that keeps the original of the image `copy`.
std::string OriginalOf(const std::string& copy) { return copy + ".original"; }

}  // namespace

std::string RunFolder::AddCopy(const std::string& file, const std::string& bytes,
                               std::string* problem) {
  const auto fail = [problem](const std::string& path) {
    *problem = CannotCopyTo(path);
    return "";
  };
  const fs::path source(file);
  // Gives each copy of an image a folder of its own, because a fork of this process uses the same
  // RunFolder, and could overwrite the copies of this process.
  std::string folder_name = folder_.path() + "/XXXXXX";
  if (mkdtemp(folder_name.data()) == nullptr) return fail(folder_.path());
  const fs::path folder = folder_name;
  const fs::path copy = folder / source.filename();
  if (!AddOriginal(copy, bytes)) return fail(copy);
  const fs::path debug = fs::path(source).replace_extension(".DBG");
  std::error_code error;
  if (fs::exists(debug, error))
    fs::create_symlink(fs::absolute(debug), folder / debug.filename(), error);
  return copy;
}

bool RunFolder::AddOriginal(const std::string& copy, const std::string& bytes) {
  const std::string original = OriginalOf(copy);
  const std::string shared =
      fmt::format("{}/{:016x}.original", folder_.path(), HashBytes(bytes.data(), bytes.size()));
  if (link(shared.c_str(), original.c_str()) == 0) return true;
  if (!Write(original, bytes)) return false;
  // If this fails, as in a file system without hard links, each robot has a file of its own.
  static_cast<void>(link(original.c_str(), shared.c_str()));
  return true;
}

std::string RunFolder::WriteCopy(const std::string& copy, const std::string& bytes) {
  return Write(copy, bytes) ? "" : CannotCopyTo(copy);
}

void RunFolder::RestoreOriginal(const std::string& copy) {
  std::error_code error;
  fs::rename(OriginalOf(copy), copy, error);
}

}  // namespace openr_host
