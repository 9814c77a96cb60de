#include "openr/input_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "runtime/config/spelling.h"

namespace openr_host {

namespace fs = std::filesystem;

std::string WhyNoFile(const std::string& path, const std::string& kind,
                      const std::string& extension) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return "";
  std::string example;  // the first in the order of names
  for (const auto& entry : fs::directory_iterator(path, error)) {
    if (!EqualsIgnoringCase(entry.path().extension().string(), extension)) continue;
    const std::string file = entry.path().string();
    if (example.empty() || file < example) example = file;
  }
  const std::string remedy = example.empty() ? "" : fmt::format(", such as {}", example);
  return fmt::format("is a folder; give a {}{}", kind, remedy);
}

}  // namespace openr_host
