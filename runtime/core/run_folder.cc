#include "runtime/core/run_folder.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace openr_host {

namespace fs = std::filesystem;

std::string RunFolder::AddCopy(const std::string& file, const std::string& bytes,
                               std::string* problem) {
  const auto fail = [problem](const std::string& path) {
    *problem = fmt::format("cannot be copied to {}: {} (TMPDIR chooses another folder)", path,
                           std::strerror(errno));
    return "";
  };
  const fs::path source(file);
  // Gives each copy of an image a folder of its own, because forks of this process use the same
  // RunFolder and could overwrite each other's copies.
  std::string folder_name = folder_.path() + "/XXXXXX";
  if (mkdtemp(folder_name.data()) == nullptr) return fail(folder_.path());
  const fs::path folder = folder_name;
  std::error_code error;
  const fs::path copy = folder / source.filename();
  std::ofstream stream(copy, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) return fail(copy);
  const fs::path debug = fs::path(source).replace_extension(".DBG");
  if (fs::exists(debug, error))
    fs::create_symlink(fs::absolute(debug), folder / debug.filename(), error);
  return copy;
}

void RunFolder::Replace(const std::string& copy, const std::string& bytes) {
  const std::string fresh = copy + ".new";
  std::ofstream stream(fresh, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  std::error_code error;
  if (stream) fs::rename(fresh, copy, error);
}

}  // namespace openr_host
