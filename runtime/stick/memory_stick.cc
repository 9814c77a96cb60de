#include "runtime/stick/memory_stick.h"

#include <dirent.h>
#include <fmt/format.h>
#include <limits.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <vector>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

constexpr char kCrashRecord[] = "EMON.LOG";

bool Exists(const std::string& path) {
  struct stat status;
  return lstat(path.c_str(), &status) == 0;
}

std::string UpperCase(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

// Returns the entry of `folder` whose name equals `part`, without regard to upper and lower case.
// If several names match, prefers the name that is exactly `part`, then the first name in the order
// of bytes.  Returns "" if no name matches.  Sets `error` if the folder cannot be read.
std::string FindEntry(const std::string& folder, const std::string& part, int* error) {
  if (Exists(folder + "/" + part)) return part;
  if (errno == EACCES) *error = EACCES;
  std::vector<std::string> matches;
  if (DIR* const dir = opendir(folder.c_str())) {
    while (const dirent* const entry = readdir(dir)) {
      if (strcasecmp(entry->d_name, part.c_str()) == 0) matches.push_back(entry->d_name);
    }
    closedir(dir);
  } else if (errno != ENOENT && errno != ENOTDIR) {
    *error = errno == EACCES ? EACCES : EIO;
  }
  return matches.empty() ? "" : *std::min_element(matches.begin(), matches.end());
}

// Returns the parts after /MS of `name`, a path on the stick, with "." and ".." resolved.  Returns
// nullopt if `name` is not below /MS.
std::optional<std::vector<std::string>> PartsOf(std::string_view name) {
  if (name.size() < 3 || strncasecmp(name.data(), "/MS", 3) != 0) return std::nullopt;
  name.remove_prefix(3);
  if (!name.empty() && name.front() != '/') return std::nullopt;
  std::vector<std::string> parts;
  while (!name.empty()) {
    name.remove_prefix(1);
    const size_t end = std::min(name.find('/'), name.size());
    const std::string_view part = name.substr(0, end);
    name.remove_prefix(end);
    if (part == "..") {
      // Refuses a name that leaves /MS, because /MS is the root folder of the stick, and the root
      // folder of a FAT file system has no entry "..".
      if (parts.empty()) return std::nullopt;
      parts.pop_back();
    } else if (!part.empty() && part != ".") {
      parts.emplace_back(part);
    }
  }
  return parts;
}

// Returns whether `path`, with symbolic links followed, is in `folder`.
bool IsBelow(const std::string& path, const std::string& folder) {
  std::error_code error;
  const auto real_path = std::filesystem::canonical(path, error);
  // Refuses a path that cannot be resolved, such as a link to a missing file, because a file that
  // is created through the link may be outside of `folder`.
  if (error) return false;
  const auto real_folder = std::filesystem::canonical(folder, error);
  const auto [end, rest] =
      std::mismatch(real_folder.begin(), real_folder.end(), real_path.begin(), real_path.end());
  return end == real_folder.end();
}

[[noreturn]] void ThrowUnreadable(const std::string& path, const std::string& why) {
  throw std::runtime_error(fmt::format("{}: the stick cannot be read: {}", path, why));
}

}  // namespace

std::optional<std::string> MemoryStick::ReadFile(std::string_view name) {
  const Location location = Locate(name);
  std::error_code error;
  if (location.error != 0 || !std::filesystem::is_regular_file(location.path, error))
    return std::nullopt;
  return openr_host::ReadFile(location.path);
}

int MemoryStick::ReadError(std::string_view name) {
  const Location location = Locate(name);
  if (location.error != 0) return location.error;
  if (!location.exists) return ENOENT;
  std::error_code error;
  if (std::filesystem::is_directory(location.path, error)) return EISDIR;
  if (!std::filesystem::is_regular_file(location.path, error)) return ENOENT;
  return access(location.path.c_str(), R_OK) == 0 ? EIO : errno;
}

void MemoryStick::HashFile(std::string_view name, std::string_view otherwise, Hasher* hasher) {
  constexpr size_t kPieceBytes = 1 << 20;
  const Location location = Locate(name);
  std::error_code error;
  std::optional<FileReader> file;
  if (location.error == 0 && std::filesystem::is_regular_file(location.path, error))
    file.emplace(location.path);
  if (!file || !file->is_open()) {
    const int why = file ? errno : ReadError(name);  // FileReader sets errno if it cannot open
    // Throws an exception after an error of the host, such as too many open files.  If the file
    // were hashed as missing instead, two runs with the same stick would have different hashes.
    if (why != ENOENT && why != EACCES && why != EISDIR && why != EINVAL && why != ENAMETOOLONG)
      ThrowUnreadable(location.path, std::strerror(why));
    return hasher->AddText(otherwise);
  }
  const uint64_t size = std::filesystem::file_size(location.path, error);
  if (error) ThrowUnreadable(location.path, error.message());
  hasher->Add(size);
  // Reads the file of the stick piece by piece, because it may be larger than the memory of the
  // host.
  std::string piece;
  for (uint64_t left = size; left > 0; left -= piece.size()) {
    const size_t wanted = std::min<uint64_t>(left, kPieceBytes);
    if (!file->Read(wanted, &piece)) ThrowUnreadable(location.path, std::strerror(errno));
    if (piece.empty()) ThrowUnreadable(location.path, std::strerror(EIO));
    hasher->AddBytes(piece.data(), piece.size());
    if (piece.size() < wanted) return;  // the file has become shorter since its size was read
  }
}

void MemoryStick::HashState(Hasher* hasher) {
  for (const std::string& name : written_) {
    hasher->AddText(name);
    HashFile(name, "(gone)", hasher);
  }
}

MemoryStick::Location FolderStick::Locate(std::string_view name) {
  const auto parts = PartsOf(name);
  if (!parts) return {"", false, ENOENT};
  std::string path = root_;
  for (size_t i = 0; i < parts->size(); ++i) {
    const std::string& part = (*parts)[i];
    if (part.find('\0') != std::string::npos) return {"", false, EINVAL};
    if (part.size() > NAME_MAX || path.size() + part.size() + 2 > PATH_MAX)
      return {"", false, ENAMETOOLONG};
    int error = 0;
    const std::string entry = FindEntry(path, part, &error);
    if (error != 0) return {"", false, error};
    const bool is_last = i + 1 == parts->size();
    if (entry.empty() && !is_last) return {"", false, ENOENT};
    if (entry.empty()) {
      // If the stick does not have the file, checks the folder in which the file would be made,
      // because this folder may be a link that leads out of the stick.
      if (!IsBelow(path, root_)) return {"", false, EACCES};
      return {path + "/" + UpperCase(part), false, 0};
    }
    path += "/" + entry;
  }
  if (!IsBelow(path, root_)) return {"", false, EACCES};
  std::error_code no_status;
  // Refuses a FIFO, a socket or a device, because opening or reading it could wait without end.
  if (std::filesystem::is_other(std::filesystem::status(path, no_status)))
    return {"", false, EACCES};
  return {path, true, 0};
}

void MemoryStick::NoteWritten(std::string_view name) {
  written_.insert(std::string(name));
  if (listeners_.empty()) return;
  const Location location = Locate(name);
  if (location.error != 0 || !changed_.insert(location.path).second) return;
  for (const ChangeListener& listener : listeners_) listener(location);
}

uint64_t FolderStick::ContentHash() {
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<std::string> names;
  special_files_.clear();
  constexpr auto kOptions = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator it(root_, kOptions, error), end; !error && it != end;
       it.increment(error)) {
    const std::string extension = UpperCase(it->path().extension().string());
    // Leaves the crash record out of the hash of the stick: an earlier run has written it, and this
    // run does not read it.
    const bool is_crash_record = UpperCase(it->path().filename().string()) == kCrashRecord;
    std::error_code no_file;  // not used: a link to a missing file gives an error and is no file
    if (it->is_other(no_file) && !is_crash_record)
      special_files_.push_back(it->path().lexically_relative(root_).string());
    if (it->is_regular_file(no_file) && extension != ".BIN" && extension != ".DBG" &&
        !is_crash_record)
      names.push_back(it->path().lexically_relative(root_).string());
  }
  if (error && error != std::errc::no_such_file_or_directory)
    ThrowUnreadable(root_, error.message());
  std::sort(special_files_.begin(), special_files_.end());
  if (names.empty()) return 0;
  std::sort(names.begin(), names.end());
  Hasher hasher;
  for (const std::string& name : names) {
    hasher.AddText(name);
    HashFile("/MS/" + name, "(unreadable)", &hasher);
  }
  return hasher.Digest();
}

MemoryStick::Location FailingStick::Locate(std::string_view name) {
  ASSERT(left_ >= 0, "{}", left_);
  if (left_ > 0 && --left_ == 0) {
    failed_name_ = name;
    return {"", false, error_};
  }
  return inner_->Locate(name);
}

bool IsShortName(std::string_view name) {
  const size_t dot = name.find('.');
  const std::string_view base = name.substr(0, dot);
  const std::string_view extension =
      dot == std::string_view::npos ? std::string_view() : name.substr(dot + 1);
  const auto allowed = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("$&#{}~%'()-@^`!_").find(c) != std::string_view::npos;
  };
  return !base.empty() && base.size() <= 8 && extension.size() <= 3 &&
         std::all_of(base.begin(), base.end(), allowed) &&
         std::all_of(extension.begin(), extension.end(), allowed);
}

}  // namespace openr_host
