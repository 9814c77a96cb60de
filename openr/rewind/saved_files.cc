#include "openr/rewind/saved_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "cli/output_file.h"
#include "runtime/base/assert.h"
#include "runtime/base/read_file.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Throw(int error, const std::string& path) {
  throw std::system_error(error, std::generic_category(), path);
}

// Opens the file `path` and makes `descriptor` refer to it, at `offset`.
void Replace(int descriptor, const std::string& path, int flags, off_t offset) {
  const int opened = open(path.c_str(), flags | O_CLOEXEC, 0666);
  if (opened < 0) Throw(errno, path);
  const bool is_good =
      lseek(opened, offset, SEEK_SET) >= 0 && dup3(opened, descriptor, O_CLOEXEC) >= 0;
  const int error = errno;
  close(opened);
  if (!is_good) Throw(error, path);
}

// Copies the first `size` bytes of the open file `from` to the new file `path`.
void CopyBytes(int from, off_t size, const std::string& path) {
  const int to = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (to < 0) Throw(errno, path);
  // Opens the file again for reading, because `from` may be open for writing only.
  const std::string source = fmt::format("/proc/self/fd/{}", from);
  const int in = open(source.c_str(), O_RDONLY | O_CLOEXEC);
  int error = in < 0 ? errno : 0;
  char buffer[64 << 10];
  for (off_t left = size; left > 0 && error == 0;) {
    const size_t wanted = std::min<size_t>(sizeof buffer, static_cast<size_t>(left));
    const ssize_t count = read(in, buffer, wanted);
    if (count <= 0) {
      error = count < 0 ? errno : 0;
      break;
    }
    left -= count;
    error = WriteAll(to, {buffer, static_cast<size_t>(count)});
  }
  if (in >= 0) close(in);
  close(to);
  if (error != 0) Throw(error, path);
}

// Returns whether a standard stream of this process leads to the file that has this `status`.  Such
// a file is not copied, because all copies of the run print to the same file.
bool IsStandardStream(const struct stat& status) {
  for (int descriptor = 0; descriptor <= STDERR_FILENO; ++descriptor) {
    struct stat stream;
    if (fstat(descriptor, &stream) == 0 && stream.st_dev == status.st_dev &&
        stream.st_ino == status.st_ino)
      return true;
  }
  return false;
}

// Returns those of `flags` that are needed to open a file again.  `flags` are the flags with which
// the file was opened before.
int FlagsAgain(int flags) { return flags & (O_ACCMODE | O_APPEND | O_NONBLOCK); }

// Returns the path with a number behind the name: DIR/NAME-NUMBER.EXT for DIR/NAME.EXT.
fs::path Numbered(const fs::path& path, int number) {
  return path.parent_path() /
         fmt::format("{}-{}{}", path.stem().string(), number, path.extension().string());
}

// Calls `copy`, a function that copies a file, with the first free path that Numbered() makes from
// `path`, and returns this path.
std::string KeepFile(const fs::path& path, const std::function<void(const fs::path&)>& copy) {
  for (int number = 2;; ++number) {
    const fs::path target = Numbered(path, number);
    try {
      copy(target);
      return target;
    } catch (const std::system_error& error) {
      if (error.code() != std::errc::file_exists) throw;
    }
  }
}

// Returns whether the file `path` belongs to a trace in the Common Trace Format.  Such a trace is a
// folder.
bool IsInTrace(const fs::path& path) { return path.parent_path().extension() == ".ctf"; }

// Makes a new trace in the Common Trace Format, the folder DIR/NAME-2.ctf, from the file `path` in
// DIR/NAME.ctf.  Also copies the file "metadata", because programs that read a trace need all files
// of its folder.  Calls `copy` with the new path of the file, and returns the new folder.
std::string KeepTrace(const fs::path& path, const std::function<void(const fs::path&)>& copy) {
  const fs::path folder = path.parent_path();
  int number = 2;
  while (!fs::create_directory(Numbered(folder, number))) ++number;
  const fs::path target = Numbered(folder, number);
  fs::copy_file(folder / "metadata", target / "metadata");
  copy(target / path.filename());
  return target;
}

}  // namespace

void SavedStick::Save(const std::string& name, const std::string& path) {
  const auto [file, is_new] = files_.try_emplace(name);
  if (!is_new) return;
  // Takes a path that cannot be looked up as a missing file.  Throws no exception, because an
  // object that writes the file would get it.
  std::error_code error;
  file->second.is_folder = fs::is_directory(path, error);
  if (!file->second.is_folder && fs::exists(path, error)) file->second.content = ReadFile(path);
}

size_t SavedStick::bytes() const {
  size_t bytes = 0;
  for (const auto& [path, saved] : files_) bytes += saved.content ? saved.content->size() : 0;
  return bytes;
}

void SavedStick::CopyTo(const std::string& folder) const {
  // files_ is sorted by path, so a folder is made before the files in the folder.
  for (const auto& [path, saved] : files_) {
    const fs::path target = fs::path(folder) / path;
    if (saved.is_folder) {
      fs::create_directories(target);
      continue;
    }
    fs::remove_all(target);
    if (!saved.content) continue;
    const std::string problem = WriteFile(target, *saved.content);
    if (!problem.empty()) throw std::runtime_error(problem);
  }
}

nlohmann::json SavedStick::ToJson() const {
  nlohmann::json json = nlohmann::json::array();
  for (const auto& [path, saved] : files_) {
    nlohmann::json content;
    if (saved.content)
      content = nlohmann::json::binary({saved.content->begin(), saved.content->end()});
    json.push_back({path, saved.is_folder, std::move(content)});
  }
  return json;
}

SavedStick SavedStick::Of(const nlohmann::json& json) {
  SavedStick stick;
  for (const nlohmann::json& each : json) {
    SavedFile& saved = stick.files_[each.at(0)];
    saved.is_folder = each.at(1);
    if (each.at(2).is_binary()) {
      const auto& bytes = each.at(2).get_binary();
      saved.content.emplace(bytes.begin(), bytes.end());
    }
  }
  return stick;
}

SavedStick SaveWrittenFiles(FolderStick* stick) {
  SavedStick saved;
  const fs::path root = fs::path(stick->root()).lexically_normal();
  for (const std::string& name : stick->written()) {
    const MemoryStick::Location location = stick->Locate(name);
    if (location.error == 0)
      saved.Save(fs::path(location.path).lexically_relative(root), location.path);
  }
  return saved;
}

ProcessFiles::ProcessFiles() {
  for (const auto& entry : fs::directory_iterator("/proc/self/fd")) {
    const std::string name = entry.path().filename();
    File file{};
    std::from_chars(name.data(), name.data() + name.size(), file.descriptor);
    struct stat status;
    if (file.descriptor <= STDERR_FILENO || fstat(file.descriptor, &status) != 0 ||
        !S_ISREG(status.st_mode) || IsStandardStream(status))
      continue;
    std::error_code error;
    file.path = fs::read_symlink(entry.path(), error);
    file.flags = fcntl(file.descriptor, F_GETFL);
    file.offset = lseek(file.descriptor, 0, SEEK_CUR);
    file.size = status.st_size;
    if (file.offset >= 0) files_.push_back(file);
  }
}

void ProcessFiles::OpenAgain(const std::string& stick, const std::string& copy,
                             const std::string& temporary) {
  const std::string stick_begin = fs::path(stick).lexically_normal().string() + "/";
  for (File& file : files_) {
    const int flags = FlagsAgain(file.flags);
    if (file.path.starts_with(stick_begin)) {
      Replace(file.descriptor, copy + "/" + file.path.substr(stick_begin.size()), flags,
              file.offset);
    } else if ((flags & O_ACCMODE) == O_RDONLY) {
      // Opens a file again even if it is open only for reading, because otherwise this fork and the
      // original process would share its offset.
      Replace(file.descriptor, fmt::format("/proc/self/fd/{}", file.descriptor), flags,
              file.offset);
    } else {
      const std::string path = fmt::format("{}/{}", temporary, file.descriptor);
      CopyBytes(file.descriptor, file.size, path);
      Replace(file.descriptor, path, flags, file.offset);
      file.is_copied = true;
    }
  }
}

std::vector<std::string> ProcessFiles::KeepCopies() {
  std::vector<std::string> kept;
  for (const File& file : files_) {
    if (!file.is_copied) continue;
    struct stat status;
    if (fstat(file.descriptor, &status) != 0) Throw(errno, file.path);
    const off_t offset = lseek(file.descriptor, 0, SEEK_CUR);
    const auto copy = [&](const fs::path& target) {
      CopyBytes(file.descriptor, status.st_size, target);
      Replace(file.descriptor, target, FlagsAgain(file.flags), offset);
    };
    kept.push_back(IsInTrace(file.path) ? KeepTrace(file.path, copy) : KeepFile(file.path, copy));
  }
  return kept;
}

std::string ProcessFiles::MoveCopy(const std::string& path, const std::string& target) {
  std::error_code error;
  const std::string real = fs::weakly_canonical(path, error);
  for (const File& file : files_) {
    if (!file.is_copied || fs::weakly_canonical(file.path, error) != real) continue;
    const std::string copy = fs::read_symlink(fmt::format("/proc/self/fd/{}", file.descriptor));
    if (target.empty()) return copy;
    for (const File& other : files_) {
      if (fs::equivalent(other.path, target, error))
        throw std::runtime_error(fmt::format("{}: is a file that the run itself writes", target));
    }
    if (std::string why = FileWriteProblem(target); !why.empty()) throw std::runtime_error(why);
    struct stat status;
    if (fstat(file.descriptor, &status) != 0) Throw(errno, copy);
    const off_t offset = lseek(file.descriptor, 0, SEEK_CUR);
    // Removes the old file first, because CopyBytes() only makes new files.
    fs::remove(target);
    CopyBytes(file.descriptor, status.st_size, target);
    Replace(file.descriptor, target, FlagsAgain(file.flags), offset);
    return fs::absolute(target);
  }
  throw std::runtime_error(fmt::format("{}: is not a file that this process writes", path));
}

}  // namespace openr_host
