// File calls of objects: paths lead to the Memory Stick, everything else is as on
// the robot or is refused.
//
// These definitions are found before the C library's by every caller in the
// process (std::ifstream included); they act only while code of an image runs.
#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <stdarg.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "runtime/core/next_symbol.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

using openr_host::ApiScope;
using openr_host::MemoryStick;
using openr_host::NextSymbol;
using openr_host::Severity;
using openr_host::t_current;

namespace {

#define OPENR_NEXT(name) (static_cast<decltype(&name)>(NextSymbol<decltype(name)>(#name)))

bool InObject() { return t_current.image_code && t_current.object != nullptr; }

void WarnOfLongName(const std::string& path) {
  const std::string name = path.substr(path.rfind('/') + 1);
  if (openr_host::IsShortName(name)) return;
  t_current.system->AddFinding(
      Severity::kWarning,
      fmt::format("{}: '{}' is not an 8.3 name; the robot's file system cannot hold it", path,
                  name));
}

// Where `path` lies on the host; empty, with errno set, when the object may not
// have it.  `writes`: the call changes the file.
std::string HostPath(const char* path, bool writes, bool may_create) {
  const ApiScope scope;
  openr_host::System* const system = t_current.system;
  MemoryStick* const stick = system->robot(t_current.object->robot).stick.get();
  if (path == nullptr || stick == nullptr) {
    errno = ENOENT;
    return "";
  }
  if (std::strncmp(path, "/MS", 3) != 0 && std::strncmp(path, "/ms", 3) != 0) {
    system->AddFinding(
        Severity::kWarning,
        fmt::format("'{}' cannot be opened: on the robot every path is absolute and begins "
                    "with /MS/",
                    path));
    errno = ENOENT;
    return "";
  }
  WarnOfLongName(path);
  const MemoryStick::Location location = stick->Locate(path);
  if (location.error != 0 || (!location.exists && !may_create)) {
    errno = location.error != 0 ? location.error : ENOENT;
    return "";
  }
  if (writes && !stick->writable()) {
    errno = EROFS;
    return "";
  }
  if (writes) stick->NoteWritten(path);
  return location.path;
}

bool OpensForWriting(int flags) {
  return (flags & O_ACCMODE) != O_RDONLY || (flags & O_CREAT) != 0;
}
bool OpensForWriting(const char* mode) { return std::strpbrk(mode, "wa+") != nullptr; }

int OpenAt(const char* path, int flags, mode_t mode) {
  static const auto next = OPENR_NEXT(open);
  if (!InObject()) return next(path, flags, mode);
  const std::string host = HostPath(path, OpensForWriting(flags), (flags & O_CREAT) != 0);
  if (host.empty()) return -1;
  const ApiScope scope;
  return next(host.c_str(), flags | O_CLOEXEC, 0666);
}

FILE* OpenFile(const char* path, const char* mode) {
  static const auto next = OPENR_NEXT(fopen);
  if (!InObject()) return next(path, mode);
  const std::string host =
      HostPath(path, OpensForWriting(mode), std::strpbrk(mode, "wa") != nullptr);
  if (host.empty()) return nullptr;
  const ApiScope scope;
  FILE* const file = next(host.c_str(), mode);
  if (file != nullptr) t_current.object->open_files.insert(file);  // closed with the object
  return file;
}

// The mode argument of open(), present only when a file may be made.
mode_t ModeOf(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

// Calls with one path: `next` gets the host's.
template <typename Function, typename... Rest>
int WithPath(Function* next, bool writes, bool may_create, const char* path, Rest... rest) {
  if (!InObject()) return next(path, rest...);
  const std::string host = HostPath(path, writes, may_create);
  return host.empty() ? -1 : next(host.c_str(), rest...);
}

// All the robot's file system tells (Programmer's Guide, appendix A).
void AsOnRobot(struct stat* status) {
  const mode_t kind = S_ISDIR(status->st_mode) ? S_IFDIR : S_IFREG;
  const off_t size = status->st_size;
  *status = {};
  status->st_mode = kind | 0777;
  status->st_size = size;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = ModeOf(flags, arguments);
  va_end(arguments);
  return OpenAt(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = ModeOf(flags, arguments);
  va_end(arguments);
  return OpenAt(path, flags, mode);
}

int creat(const char* path, mode_t mode) {
  return OpenAt(path, O_CREAT | O_WRONLY | O_TRUNC, mode);
}

FILE* fopen(const char* path, const char* mode) { return OpenFile(path, mode); }
FILE* fopen64(const char* path, const char* mode) { return OpenFile(path, mode); }

int fclose(FILE* file) {
  static const auto next = OPENR_NEXT(fclose);
  if (InObject()) {
    const ApiScope scope;
    t_current.object->open_files.erase(file);
  }
  return next(file);
}

int stat(const char* path, struct stat* status) noexcept {
  static const auto next = OPENR_NEXT(stat);
  const int result = WithPath(next, false, false, path, status);
  if (result == 0 && InObject()) AsOnRobot(status);
  return result;
}

int access(const char* path, int mode) noexcept {
  static const auto next = OPENR_NEXT(access);
  return WithPath(next, false, false, path, mode);
}

int mkdir(const char* path, mode_t mode) noexcept {
  static const auto next = OPENR_NEXT(mkdir);
  return WithPath(next, true, true, path, InObject() ? mode_t{0777} : mode);
}

int rmdir(const char* path) noexcept {
  static const auto next = OPENR_NEXT(rmdir);
  return WithPath(next, true, false, path);
}

int unlink(const char* path) noexcept {
  static const auto next = OPENR_NEXT(unlink);
  return WithPath(next, true, false, path);
}

int remove(const char* path) noexcept {
  static const auto next = OPENR_NEXT(remove);
  return WithPath(next, true, false, path);
}

int rename(const char* from, const char* to) noexcept {
  static const auto next = OPENR_NEXT(rename);
  if (!InObject()) return next(from, to);
  const std::string host_from = HostPath(from, true, false);
  if (host_from.empty()) return -1;
  const std::string host_to = HostPath(to, true, true);
  return host_to.empty() ? -1 : next(host_from.c_str(), host_to.c_str());
}

DIR* opendir(const char* path) {
  static const auto next = OPENR_NEXT(opendir);
  if (!InObject()) return next(path);
  const std::string host = HostPath(path, false, false);
  const ApiScope scope;
  return host.empty() ? nullptr : next(host.c_str());
}

}  // extern "C"
