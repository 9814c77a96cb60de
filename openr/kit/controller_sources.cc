#include "openr/kit/controller_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "openr/kit/text_files.h"
#include "runtime/config/line_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> SourcesIn(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file(error) && IsSourceName(entry.path())) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// The part of a line that says what a variable is, or goes on doing so; without a comment.
std::string Value(const std::string& line, bool goes_on) {
  static const std::regex kAssignment("^[ \t]*[A-Za-z_][A-Za-z0-9_.]*[ \t]*[:+?]?=(.*)$");
  const std::string text = line.substr(0, line.find('#'));
  std::smatch match;
  if (goes_on) return text;
  return std::regex_match(text, match, kAssignment) ? match[1].str() : "";
}

void ReadList(const fs::path& folder, ControllerSources* sources) {
  const std::string text = ReadText(sources->list).value_or("");
  bool goes_on = false;
  for (const Place& line : SplitLines(sources->list, text, &sources->diagnostics)) {
    std::string value = Value(line.text, goes_on);
    goes_on = !value.empty() && value.find_last_not_of(" \t\r") != std::string::npos &&
              value[value.find_last_not_of(" \t\r")] == '\\';
    if (value.find("$(wildcard") != std::string::npos) {
      sources->files = SourcesIn(folder);
      return;
    }
    std::replace(value.begin(), value.end(), '\\', ' ');
    std::istringstream words(value);
    for (std::string word; words >> word;) {
      if (!IsSourceName(word)) continue;
      const fs::path file = (folder / word).lexically_normal();
      if (std::find(sources->files.begin(), sources->files.end(), file) != sources->files.end())
        continue;
      sources->files.push_back(file);
      if (fs::is_regular_file(file)) continue;
      const int column = static_cast<int>(line.text.find(word)) + 1;
      sources->diagnostics.push_back({Severity::kError, line.file, line.line, column,
                                      fmt::format("there is no file '{}'", word), line.text});
    }
  }
}

}  // namespace

ControllerSources FindControllerSources(const fs::path& folder) {
  ControllerSources sources;
  sources.list = FindEntry(folder, "Makefile.sources");
  if (sources.list.empty()) {
    sources.files = SourcesIn(folder);
  } else {
    ReadList(folder, &sources);
  }
  return sources;
}

bool IsControllerFolder(const fs::path& folder) {
  if (!FindEntry(folder, "Makefile.sources").empty()) return true;
  static const std::regex kInclude("#[ \t]*include[ \t]*[<\"](device/)?robot\\.h[>\"]");
  const std::vector<fs::path> files = SourcesIn(folder);
  return std::any_of(files.begin(), files.end(), [](const fs::path& file) {
    return std::regex_search(ReadText(file).value_or(""), kInclude);
  });
}

}  // namespace openr_host
