#include "kit/sdk_paths.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace openr_host {

std::string SdkRoot() {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const fs::path prefix = self.parent_path().parent_path();
  const fs::path root = prefix / "share" / "openr-host" / "sdk";
  if (!error && fs::is_regular_file(root / "compile-flags.txt", error)) return root;
  throw std::runtime_error(root.string() +
                           " is missing; it belongs to the program (build the target 'sdk_tree', "
                           "or install it whole: of the Debian packages openr-host-dev)");
}

std::vector<std::string> ParseCompileFlags(const std::string& text, Language language,
                                           bool is_clang) {
  const std::string name = language == Language::kC ? "c" : "c++";
  std::vector<std::string> flags;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string what, flag;
    if (!(words >> what >> flag) || what[0] == '#') continue;
    const size_t comma = what.find(',');
    const std::string compiler = comma == std::string::npos ? "" : what.substr(comma + 1);
    const std::string for_language = what.substr(0, comma);
    if (for_language != "all" && for_language != name) continue;
    if (!compiler.empty() && compiler != (is_clang ? "clang" : "gnu")) continue;
    flags.push_back(flag);
  }
  return flags;
}

std::vector<std::string> HostCompiler(Language language) {
  const char* const given = std::getenv(language == Language::kCxx ? kCxxVariable : kCcVariable);
  std::istringstream words(given == nullptr ? "" : given);
  std::vector<std::string> compiler;
  // Splits the value of the environment variable into words, because the value may begin with a
  // program such as ccache.
  for (std::string word; words >> word;) compiler.push_back(word);
  if (compiler.empty()) compiler.push_back(language == Language::kCxx ? "g++" : "gcc");
  return compiler;
}

bool IsClang(const std::vector<std::string>& compiler) {
  for (const std::string& word : compiler) {
    if (word.find("clang") != std::string::npos) return true;
  }
  return false;
}

}  // namespace openr_host
