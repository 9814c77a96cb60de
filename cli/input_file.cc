#include "cli/input_file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "runtime/base/spelling.h"

namespace openr_host {

namespace fs = std::filesystem;

namespace {

// Returns an example for an error message, ", such as DIR/A.MTN": a file of `folder` that ends in
// `extension`.  If there are several such files, takes the first by name; if there is none,
// returns "".
std::string ExampleIn(const std::string& folder, const std::string& extension) {
  std::error_code error;
  std::string example;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!EqualsIgnoringCase(entry.path().extension().string(), extension)) continue;
    const std::string file = entry.path().string();
    if (example.empty() || file < example) example = file;
  }
  return example.empty() ? "" : fmt::format(", such as {}", example);
}

}  // namespace

std::string FileReadProblem(const std::string& path, const std::string& kind,
                            const std::string& extension) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::strerror(errno);
  if (S_ISDIR(status.st_mode))
    return fmt::format("is a folder; give a {}{}", kind, ExampleIn(path, extension));
  // Checks the access rights and does not open the file, because opening a pipe would wait for a
  // process that writes to it.
  return access(path.c_str(), R_OK) == 0 ? "" : std::strerror(errno);
}

std::string FolderReadProblem(const std::string& path, const std::string& kind) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::strerror(errno);
  if (!S_ISDIR(status.st_mode)) return fmt::format("is a file; give a {}", kind);
  return access(path.c_str(), R_OK | X_OK) == 0 ? "" : std::strerror(errno);
}

void RequireReadable(const std::string& path, const InputKind& kind) {
  const std::string problem = FileReadProblem(path, kind.kind, kind.extension);
  if (!problem.empty()) throw std::runtime_error(fmt::format("{}: {}", path, problem));
}

}  // namespace openr_host
