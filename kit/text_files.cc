#include "kit/text_files.h"

#include <strings.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstring>

#include "cli/output_file.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

bool HasExtension(const fs::path& file, std::initializer_list<const char*> extensions) {
  const std::string extension = file.extension();
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

// Adds the files below `folder` to `files`.  `open` has the real paths of the folders that contain
// `folder`.  Does not follow a link to one of these folders, because the search would then never
// end.
void AddFiles(const fs::path& folder, std::vector<fs::path>* open, std::vector<fs::path>* files) {
  std::error_code error;
  const fs::path real = fs::canonical(folder, error);
  if (error || std::find(open->begin(), open->end(), real) != open->end()) return;
  open->push_back(real);
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder, error)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  for (const fs::path& entry : entries) {
    if (fs::is_directory(entry, error)) {
      if (!IsIgnoredFolder(entry)) AddFiles(entry, open, files);
    } else if (fs::is_regular_file(entry, error)) {
      files->push_back(entry);
    }
  }
  open->pop_back();
}

}  // namespace

std::optional<std::string> ReadText(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  return ReadFile(file);
}

std::string WriteText(const fs::path& file, const std::string& text) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  // Ignores the error that a part of the path is a file and not a folder, because WriteFile()
  // reports this error with the name of the file.
  if (error && error != std::errc::not_a_directory)
    return Explain(fs::filesystem_error("", file.parent_path(), error));
  return WriteFile(file, text);
}

std::string LowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string WithoutOddCharacters(std::string path) {
  for (char& c : path) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                          std::string_view("/._+-").find(c) != std::string_view::npos;
    if (!is_plain) c = '_';
  }
  return path;
}

fs::path FindEntry(const fs::path& folder, const std::string& name) {
  std::error_code error;
  if (fs::exists(folder / name, error)) return folder / name;
  std::vector<fs::path> matches;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (strcasecmp(entry.path().filename().c_str(), name.c_str()) == 0)
      matches.push_back(entry.path());
  }
  // Takes the first name in order, because the order of entries in a folder differs between
  // machines.
  return matches.empty() ? fs::path() : *std::min_element(matches.begin(), matches.end());
}

fs::path FindBelow(fs::path folder, const std::string& path) {
  for (const fs::path& part : fs::path(path)) {
    folder = FindEntry(folder, part);
    if (folder.empty()) break;
  }
  return folder;
}

fs::path WithCaseOnDisk(fs::path folder, const std::string& path) {
  for (const fs::path& part : fs::path(path)) {
    const fs::path there = FindEntry(folder, part);
    folder = there.empty() ? folder / part : there;
  }
  return folder;
}

bool IsSourceName(const fs::path& file) {
  return HasExtension(file, {".cc", ".cpp", ".cxx", ".C", ".c", ".CPP", ".CC"});
}

bool IsHeaderName(const fs::path& file) {
  return HasExtension(file, {".h", ".hh", ".hpp", ".H", ".hxx", ".inl", ".icc", ".tcc"});
}

bool IsMainMakefileName(const fs::path& file) {
  const std::string name = file.filename();
  return name == "Makefile" || name == "makefile" || name == "GNUmakefile";
}

bool IsMakefileName(const fs::path& file) {
  const std::string name = LowerCase(file.filename());
  return name.starts_with("makefile") || name.starts_with("gnumakefile") ||
         name.starts_with("make.") || HasExtension(file, {".mk", ".mak", ".make", ".mf"});
}

bool IsIgnoredFolder(const fs::path& folder) {
  const std::string name = folder.filename();
  std::error_code error;
  return name == "CVS" || name.starts_with(".") || fs::exists(folder / "CMakeCache.txt", error);
}

bool IsBelow(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

std::vector<fs::path> FilesBelow(const fs::path& folder) {
  std::vector<fs::path> open, files;
  AddFiles(folder, &open, &files);
  return files;
}

std::string PathReadProblem(const fs::path& path) {
  std::error_code error;
  const int wanted = fs::is_directory(path, error) ? R_OK | X_OK : R_OK;
  if (access(path.c_str(), wanted) == 0 || errno != EACCES) return "";
  return std::string("cannot be read: ") + std::strerror(errno);
}

std::vector<fs::path> UnreadableBelow(const fs::path& folder) {
  std::vector<fs::path> all;
  if (!PathReadProblem(folder).empty()) return {folder};
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const bool is_folder = entry.is_directory(error) && !entry.is_symlink(error);
    if (is_folder && IsIgnoredFolder(entry.path())) continue;
    if (is_folder) {
      const std::vector<fs::path> more = UnreadableBelow(entry.path());
      all.insert(all.end(), more.begin(), more.end());
    } else if (!PathReadProblem(entry.path()).empty()) {
      all.push_back(entry.path());
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace openr_host
