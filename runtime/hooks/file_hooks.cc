// File functions for objects: open(), fopen(), stat() and the like.  Paths of an object lead to its
// Memory Stick.  Operations that the robot's file system does not have fail.
//
// A call from anywhere in the process, even in std::ifstream, goes to these functions instead of
// the functions of the C library.  While no code of an object runs, these functions do the same as
// those of the C library.
#include <fcntl.h>
#include <fmt/format.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/core/arena.h"
#include "runtime/core/code_place.h"
#include "runtime/core/memory_tools.h"
#include "runtime/core/system.h"
#include "runtime/core/write_errors.h"
#include "runtime/hooks/hook.h"
#include "runtime/hooks/open_file.h"
#include "runtime/hooks/stick_call.h"
#include "runtime/stick/memory_stick.h"

using openr_host::ApiScope;
using openr_host::HostPath;
using openr_host::InObject;
using openr_host::OpenFiles;
using openr_host::Severity;
using openr_host::StickUse;
using openr_host::t_current;

namespace {

// Makes the host write a file or folder to the disk now, so that a power cut does not lose it.
// Used by rename(), unlink(), rmdir() and remove(): a program may call one of them to replace or
// remove a file, and then report success.  A later power cut must not lose the new file or bring
// back the removed file.  Returns EIO or ENOSPC if the disk could not store the bytes, otherwise 0.
// Ignores other errors, because some file systems cannot write a single file to the disk.  Keeps
// errno.
//
// Does this also for the copy of the default stick, which is removed at the end of its run, because
// otherwise a full disk would not be noticed.  The cost is small: a program that searches for a
// good walk, and uploads two motions for each try, spends 4 % of its time here.
int WriteThrough(const std::string& host_path) {
  const ApiScope scope;  // makes open() take `host_path` as a path of the host
  const int error = errno;
  int lost = 0;
  if (const int descriptor = open(host_path.c_str(), O_RDONLY | O_CLOEXEC); descriptor >= 0) {
    if (fsync(descriptor) != 0 && (errno == EIO || errno == ENOSPC || errno == EDQUOT))
      lost = errno == EIO ? EIO : ENOSPC;
    close(descriptor);
  }
  errno = error;
  return lost;
}

// Makes the host write the folder of `host_path` to the disk, as WriteThrough() does, after an
// entry of the folder has changed.  Ignores errors of the disk, because the change cannot be taken
// back.
void WriteFolderThrough(const std::string& host_path) {
  const ApiScope scope;  // keeps the path of the folder out of the object's heap
  WriteThrough(host_path.substr(0, host_path.rfind('/')));
}

// Returns whether every part of `path` is a name that the robot's file system can hold.
bool HasShortNames(std::string_view path) {
  for (path.remove_prefix(std::min<size_t>(path.size(), 3)); !path.empty();) {
    path.remove_prefix(1);
    const std::string_view part = path.substr(0, path.find('/'));
    // Allows "." and ".." as parts of a path, because every folder except the root has these
    // entries.
    const bool is_dots = part == "." || part == "..";
    if (!part.empty() && !is_dots && !openr_host::IsShortName(part)) return false;
    path.remove_prefix(part.size());
  }
  return true;
}

// Adds a finding if a part of `path` is not an 8.3 name.  With --strict, also sets errno and
// returns false, because the call has to fail.
bool CheckNames(const std::string& path) {
  if (HasShortNames(path)) return true;
  openr_host::System* const system = t_current.system;
  const bool strict = system->options().strict;
  system->AddFinding(strict ? Severity::kError : Severity::kWarning,
                     fmt::format("{}: '{}' is not an 8.3 name; the robot's file system cannot hold "
                                 "it",
                                 path, path.substr(path.rfind('/') + 1)));
  if (strict) errno = ENOENT;
  return !strict;
}

// Returns whether open() with `flags` may change the file.  Returns true also for O_RDONLY with
// O_CREAT or O_TRUNC, because the host's open() then creates or empties the file.
bool OpensForWriting(int flags) {
  return (flags & O_ACCMODE) != O_RDONLY || (flags & (O_CREAT | O_TRUNC)) != 0;
}
bool OpensForWriting(const char* mode) { return std::strpbrk(mode, "wa+") != nullptr; }

StickUse UseOf(int flags) {
  return (flags & O_CREAT) != 0   ? StickUse::kCreate
         : OpensForWriting(flags) ? StickUse::kChange
                                  : StickUse::kRead;
}
StickUse UseOf(const char* mode) {
  return std::strpbrk(mode, "wa") != nullptr ? StickUse::kCreate
         : OpensForWriting(mode)             ? StickUse::kChange
                                             : StickUse::kRead;
}

// Returns whether the current object may open the file `path` of the stick, whose path on the host
// is `host`.  `writes` is true if the file is opened for writing.  If the object may not open the
// file, sets errno.  A file that is already open can be opened again only if all its users only
// read it (Programmer's Guide, appendix A).
bool MayOpen(const std::string& host, bool writes, const char* path) {
  const ApiScope scope;
  const openr_host::Object* holder = nullptr;
  openr_host::AnyObjectOfRobot([&](openr_host::Object* object) {
    const auto bars = [&](const auto& open) {
      return open.second.path == host && (writes || open.second.writes);
    };
    const openr_host::OpenFiles& files = object->files();
    if (std::any_of(files.streams.begin(), files.streams.end(), bars) ||
        std::any_of(files.descriptors.begin(), files.descriptors.end(), bars))
      holder = object;
    return holder != nullptr;
  });
  if (holder == nullptr) return true;
  t_current.system->AddFinding(
      Severity::kWarning,
      fmt::format("{} is refused: {} has it open already, and on the robot a file can be open "
                  "twice only if nobody writes it",
                  path, holder->name));
  errno = EACCES;
  return false;
}

int OpenAt(const char* path, int flags, mode_t mode) {
  static const auto next = OPENR_NEXT(open);
  if (!InObject()) return next(path, flags, mode);
  const std::string host = HostPath(path, UseOf(flags));
  const bool writes = OpensForWriting(flags);
  if (host.empty() || !MayOpen(host, writes, path)) return -1;
  const ApiScope scope;
  const int descriptor = next(host.c_str(), flags | O_CLOEXEC, 0666);
  if (descriptor >= 0) t_current.object->files().descriptors[descriptor] = {host, writes, path};
  return descriptor;
}

FILE* Remember(FILE* file, const std::string& host, bool writes, const char* path) {
  if (file != nullptr) t_current.object->files().streams[file] = {host, writes, path};
  return file;
}

FILE* OpenFile(const char* path, const char* mode) {
  static const auto next = OPENR_NEXT(fopen);
  if (!InObject()) return next(path, mode);
  const std::string host = HostPath(path, UseOf(mode));
  const bool writes = OpensForWriting(mode);
  if (host.empty() || !MayOpen(host, writes, path)) return nullptr;
  const ApiScope scope;
  return Remember(next(host.c_str(), mode), host, writes, path);
}

// Returns the table of open files that has `file`; null if no table has it.  Searches the current
// object first, which is not in the table of objects while its constructors run.  Searches all
// objects, because an object may close a stream of another object.
OpenFiles* HolderOf(FILE* file) {
  if (t_current.object->files().streams.contains(file)) return &t_current.object->files();
  for (const auto& object : t_current.system->objects()) {
    if (object != nullptr && object->files().streams.contains(file)) return &object->files();
  }
  return nullptr;
}

// Removes `file`, which is about to be closed, from the table of open files that has it, and
// returns the record that the table had of it.  Adds a finding if an earlier write to the file has
// failed.
OpenFiles::File ForgetStream(FILE* file) {
  const ApiScope scope;
  OpenFiles* const holder = HolderOf(file);
  if (holder == nullptr) return {};
  const auto found = holder->streams.find(file);
  OpenFiles::File forgotten = std::move(found->second);
  holder->streams.erase(found);
  if (forgotten.writes && ferror(file) != 0) openr_host::ReportWriteError(&forgotten, 0);
  return forgotten;
}

// Returns whether fclose() of the C library may close `file` for an object.  Otherwise adds a
// finding and sets errno: the object has closed the stream already, or never had it.  The C library
// would end the process, because it would free memory in which no stream is.
bool MayClose(FILE* file) {
  if (HolderOf(file) != nullptr) return true;
  // Allows streams that are in the object's heap, because fmemopen() and open_memstream(), which
  // are no hooks, make them there.  Allows all streams if the object's heap is not used
  // (heap_hooks.cc).  A null pointer is left to the C library, too.
  const bool has_heap =
      t_current.object->memory().arena() != nullptr && !openr_host::IsStackWatched();
  if (file == nullptr || !has_heap || openr_host::Arena::OwnerOf(file) != nullptr) return true;
  const ApiScope scope;
  t_current.system->AddFinding(
      Severity::kError,
      fmt::format("{}fclose() of a stream that is not open{}: on the robot this damages memory "
                  "without a word; here it changes nothing",
                  openr_host::InHandler(), openr_host::AtCaller()));
  errno = EBADF;
  return false;
}

// Returns the optional argument `mode` of open(), or 0 if the caller has not passed it.  Callers
// pass `mode` only with flags that may create a file.
mode_t ModeOf(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

// Removes `descriptor` from the open files of the object that has opened it.  Searches all objects
// of the current object's robot, because an object may close a descriptor of another object.
// Returns false if none of these objects has opened the descriptor.
bool ForgetDescriptor(int descriptor) {
  return openr_host::AnyObjectOfRobot([descriptor](openr_host::Object* object) {
    return object->files().descriptors.erase(descriptor) == 1;
  });
}

// Calls `next`, a function of the C library, with `path`.  If an object is the caller, passes the
// path of the same file on the host instead, or returns -1 if the object may not use the file in
// the way `use`.
template <typename Function, typename... Rest>
int WithPath(Function* next, StickUse use, const char* path, Rest... rest) {
  if (!InObject()) return next(path, rest...);
  const std::string host = HostPath(path, use);
  return host.empty() ? -1 : next(host.c_str(), rest...);
}

// Removes `path` with `next`, which is unlink(), rmdir() or remove() of the C library.  If an
// object is the caller, removes the file or folder of the stick that has this path, and then writes
// its parent folder to the host's disk.
int RemoveThrough(int (*next)(const char*), const char* path) {
  if (!InObject()) return next(path);
  const std::string host = HostPath(path, StickUse::kChange);
  if (host.empty()) return -1;
  const int result = next(host.c_str());
  if (result == 0) WriteFolderThrough(host);
  return result;
}

// Clears all fields of `status`, the result of stat() for a file or folder, except its kind and
// size, because the robot's file system reports only these two (Programmer's Guide, appendix A).
template <typename Status>
void AsOnRobot(Status* status) {
  const mode_t kind = S_ISDIR(status->st_mode) ? S_IFDIR : S_IFREG;
  const auto size = status->st_size;
  *status = {};
  status->st_mode = kind | 0777;
  status->st_size = size;
}

}  // namespace

namespace openr_host {

std::string HostPath(const char* path, StickUse use) {
  const ApiScope scope;
  System* const system = t_current.system;
  MemoryStick* const stick = system->robot(t_current.object->robot).stick.get();
  if (path == nullptr || stick == nullptr) {
    errno = ENOENT;
    return "";
  }
  if (std::strlen(path) >= PATH_MAX) {
    // Does not name the path, because the text would be too long to read.
    system->AddFinding(
        Severity::kWarning,
        fmt::format("a path of {} characters names no file of the stick: a path has less than {}",
                    std::strlen(path), PATH_MAX));
    errno = ENAMETOOLONG;
    return "";
  }
  if (strncasecmp(path, "/MS", 3) != 0) {
    system->AddFinding(
        Severity::kWarning,
        fmt::format("'{}' cannot be opened: on the robot every path is absolute and begins "
                    "with /MS/",
                    path));
    errno = ENOENT;
    return "";
  }
  if (!CheckNames(path)) return "";
  const MemoryStick::Location location = stick->Locate(path);
  if (location.error != 0 || (!location.exists && use != StickUse::kCreate)) {
    errno = location.error != 0 ? location.error : ENOENT;
    return "";
  }
  if (use == StickUse::kRead) return location.path;
  if (!stick->writable()) {
    system->AddFinding(Severity::kNote,
                       fmt::format("{} cannot be written: the stick is write-protected", path));
    errno = EROFS;
    return "";
  }
  system->calls().NoteFileWritten(path);
  return location.path;
}

}  // namespace openr_host

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
int creat64(const char* path, mode_t mode) { return creat(path, mode); }

FILE* fopen(const char* path, const char* mode) { return OpenFile(path, mode); }
FILE* fopen64(const char* path, const char* mode) { return OpenFile(path, mode); }

FILE* freopen64(const char* path, const char* mode, FILE* file) {
  return freopen(path, mode, file);
}
FILE* freopen(const char* path, const char* mode, FILE* file) {
  static const auto next = OPENR_NEXT(freopen);
  if (!InObject() || path == nullptr) return next(path, mode, file);
  // Refuses freopen() of stdin, stdout and stderr, because on the host these streams of the
  // terminal belong to the whole run.
  if (file == stdin || file == stdout || file == stderr) {
    const ApiScope scope;
    t_current.system->AddFinding(
        Severity::kWarning, fmt::format("freopen({}) of a stream of the terminal fails: all "
                                        "objects of the run share it; open a file with fopen()",
                                        path));
    errno = EACCES;
    return nullptr;
  }
  const std::string host = HostPath(path, UseOf(mode));
  const bool writes = OpensForWriting(mode);
  // Writes the bytes that the stream `file` still holds to the old file of the stream, before
  // freopen() closes that file.  freopen() would also write these bytes, but would not report an
  // error.
  if (t_current.object->files().streams.contains(file)) static_cast<void>(fflush(file));
  ForgetStream(file);
  const bool may_open = !host.empty() && MayOpen(host, writes, path);
  const ApiScope scope;
  if (may_open) return Remember(next(host.c_str(), mode, file), host, writes, path);
  const int error = errno;
  fclose(file);  // closes the old file, as freopen() of the C library does when it fails
  errno = error;
  return nullptr;
}

int fclose(FILE* file) {
  static const auto next = OPENR_NEXT(fclose);
  if (!InObject()) return next(file);
  // Leaves a stream of the console open and reports success, as close() does, because the console
  // belongs to the whole run.
  if (file == stdin || file == stdout || file == stderr) return 0;
  if (!MayClose(file)) return EOF;
  OpenFiles::File written = ForgetStream(file);
  const int result = next(file);
  // fclose() has written the last bytes of the file, so an error may mean that some bytes are lost.
  if (result != 0 && written.writes) openr_host::ReportWriteError(&written, errno);
  return result;
}

int close(int descriptor) {
  static const auto next = OPENR_NEXT(close);
  if (!InObject()) return next(descriptor);
  const ApiScope scope;
  // Leaves a descriptor of the console open and reports success, because the console belongs to the
  // whole run.
  if (openr_host::IsConsole(descriptor)) return 0;
  if (ForgetDescriptor(descriptor)) return next(descriptor);
  openr_host::RefusesDescriptor("close", descriptor);
  errno = EBADF;  // refuses, because an object must not close descriptors of the host
  return -1;
}

int stat(const char* path, struct stat* status) noexcept {
  static const auto next = OPENR_NEXT(stat);
  const int result = WithPath(next, StickUse::kRead, path, status);
  if (result == 0 && InObject()) AsOnRobot(status);
  return result;
}

int lstat(const char* path, struct stat* status) noexcept {
  static const auto next = OPENR_NEXT(lstat);
  return InObject() ? stat(path, status) : next(path, status);
}

int fstat(int descriptor, struct stat* status) noexcept {
  static const auto next = OPENR_NEXT(fstat);
  if (!InObject()) return next(descriptor, status);
  if (openr_host::RefusesDescriptor("fstat", descriptor)) return -1;
  if (openr_host::IsConsole(descriptor)) {
    // Leaves the size 0: the host's standard output may be a file, and its size must not show.
    *status = {};
  } else if (next(descriptor, status) != 0) {
    return -1;
  }
  AsOnRobot(status);
  return 0;
}

// Programs that are compiled for large files call the following functions.  The two structs have
// the same members.
static_assert(sizeof(struct stat64) == sizeof(struct stat));
int stat64(const char* path, struct stat64* status) noexcept {
  return stat(path, reinterpret_cast<struct stat*>(status));
}
int lstat64(const char* path, struct stat64* status) noexcept {
  return lstat(path, reinterpret_cast<struct stat*>(status));
}
int fstat64(int descriptor, struct stat64* status) noexcept {
  return fstat(descriptor, reinterpret_cast<struct stat*>(status));
}

int access(const char* path, int mode) noexcept {
  static const auto next = OPENR_NEXT(access);
  return WithPath(next, StickUse::kRead, path, mode);
}

int mkdir(const char* path, mode_t mode) noexcept {
  static const auto next = OPENR_NEXT(mkdir);
  return WithPath(next, StickUse::kCreate, path, InObject() ? mode_t{0777} : mode);
}

int rmdir(const char* path) noexcept {
  static const auto next = OPENR_NEXT(rmdir);
  return RemoveThrough(next, path);
}

int unlink(const char* path) noexcept {
  static const auto next = OPENR_NEXT(unlink);
  return RemoveThrough(next, path);
}

int remove(const char* path) noexcept {
  static const auto next = OPENR_NEXT(remove);
  return RemoveThrough(next, path);
}

int rename(const char* from, const char* to) noexcept {
  static const auto next = OPENR_NEXT(rename);
  if (!InObject()) return next(from, to);
  const std::string host_from = HostPath(from, StickUse::kChange);
  if (host_from.empty()) return -1;
  const std::string host_to = HostPath(to, StickUse::kCreate);
  if (host_to.empty()) return -1;
  if (const int error = WriteThrough(host_from); error != 0) {
    errno = error;
    return -1;
  }
  const int result = next(host_from.c_str(), host_to.c_str());
  if (result == 0) WriteFolderThrough(host_to);
  return result;
}

}  // extern "C"
