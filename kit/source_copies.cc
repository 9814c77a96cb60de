#include "kit/source_copies.h"

#include <cstdlib>
#include <sstream>

#include "kit/sdk_paths.h"

namespace openr_host {

std::vector<SourceCopy> SourceCopies() {
  std::vector<SourceCopy> copies;
  const char* const text = std::getenv(kCopiesVariable);
  std::istringstream entries(text == nullptr ? "" : text);
  for (std::string entry; std::getline(entries, entry, ':');) {
    const size_t equals = entry.find('=');
    if (equals == std::string::npos) continue;
    copies.push_back({entry.substr(0, equals), entry.substr(equals + 1)});
  }
  return copies;
}

std::string ToEnvironment(const std::vector<SourceCopy>& copies) {
  std::string text;
  for (const SourceCopy& entry : copies) {
    if (!text.empty()) text += ':';
    text += entry.copy + '=' + entry.original;
  }
  return text;
}

std::string InTermsOfOriginals(std::string text, const std::vector<SourceCopy>& copies) {
  for (const SourceCopy& entry : copies) {
    for (size_t at = text.find(entry.copy); at != std::string::npos;
         at = text.find(entry.copy, at + entry.original.size()))
      text.replace(at, entry.copy.size(), entry.original);
  }
  return text;
}

std::string OriginalOf(const std::string& file, const std::vector<SourceCopy>& copies) {
  for (const SourceCopy& entry : copies) {
    if (file == entry.copy) return entry.original;
    if (file.starts_with(entry.copy + '/')) return entry.original + file.substr(entry.copy.size());
  }
  return "";
}

}  // namespace openr_host
