#include "runtime/config/stick_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "runtime/base/spelling.h"

namespace openr_host {
namespace {

constexpr std::string_view kRoot = "/MS/";
constexpr size_t kBaseNameMax = 8;   // limit of FAT for a name (Programmer's Guide A.1)
constexpr size_t kExtensionMax = 3;  // limit of FAT for the extension of a name

bool StartsWithRoot(std::string_view path) {
  return EqualsIgnoringCase(path.substr(0, kRoot.size()), kRoot);
}

// Returns a proposal for the end of an error message about `path`.  If only the beginning of the
// path is missing, it is "; did you mean '/MS/OPEN-R/...'?", otherwise "".
std::string Suggestion(const std::string& path) {
  for (const std::string_view prefix : {"", "/", "/MS/", "/MS"}) {
    const std::string candidate = std::string(prefix) + path;
    if (EqualsIgnoringCase(candidate.substr(0, 11), "/MS/OPEN-R/")) {
      return fmt::format("; did you mean '{}'?", candidate);
    }
  }
  return "";
}

bool IsShortName(std::string_view part) {
  const size_t dot = part.find('.');
  const std::string_view base = part.substr(0, dot);
  const std::string_view extension =
      dot == std::string_view::npos ? std::string_view() : part.substr(dot + 1);
  return !base.empty() && base.size() <= kBaseNameMax && extension.size() <= kExtensionMax &&
         extension.find('.') == std::string_view::npos;
}

}  // namespace

bool CheckStickPath(const Word& word, const FilePosition& place, const char* what,
                    std::vector<Diagnostic>* diagnostics) {
  const std::string& path = word.text;
  if (path.find('\\') != std::string::npos) {
    std::string slashed = path;
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    diagnostics->push_back(
        ErrorAt(AtColumn(place, word.column + static_cast<int>(path.find('\\'))),
                fmt::format("{} '{}' has a backslash; did you mean '{}'?", what, path, slashed)));
    return false;
  }
  if (!StartsWithRoot(path)) {
    diagnostics->push_back(
        ErrorAt(AtColumn(place, word.column),
                fmt::format("{} '{}' does not begin with /MS/, the root of the Memory Stick{}",
                            what, path, Suggestion(path))));
    return false;
  }
  size_t start = kRoot.size();
  while (true) {
    const size_t end = std::min(path.find('/', start), path.size());
    const std::string part = path.substr(start, end - start);
    const FilePosition here = AtColumn(place, word.column + static_cast<int>(start));
    if (part.empty() || part == "." || part == "..") {
      const char* fault = part.empty() ? "an empty part" : "a part that is only dots";
      diagnostics->push_back(
          ErrorAt(here, fmt::format("{} '{}' has {}; write the whole path", what, path, fault)));
      return false;
    }
    if (!IsShortName(part)) {
      diagnostics->push_back(
          WarningAt(here, fmt::format("'{}' is not an 8.3 name; the robot cannot open it", part)));
    }
    if (end == path.size()) return true;
    start = end + 1;
  }
}

}  // namespace openr_host
