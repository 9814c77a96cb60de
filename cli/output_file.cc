#include "cli/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

#include "cli/file_lock.h"
#include "cli/standard_streams.h"
#include "runtime/base/read_file.h"

namespace openr_host {

namespace fs = std::filesystem;

namespace {

constexpr int kLinksMax = 40;  // longest chain of symbolic links; the kernel has the same limit
constexpr int kTemporaryNamesMax = 100;  // number of tries to find a name that no file has

// The open stream or the file that a file name means.
struct Target {
  int stream = -1;   // descriptor of an open stream of this process; -1: the name means a file
  std::string path;  // path of the file, after symbolic links were followed
  bool exists = false;
  struct stat status {};  // status of the file; set only if `exists`
};

// Returns the descriptor that the names /dev/fd/N and /proc/self/fd/N mean; -1 for other names.
int StreamCalled(const fs::path& path) {
  const std::string name = path.filename();
  const bool is_number =
      !name.empty() && name.size() < 8 &&
      std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  if (!is_number) return -1;
  std::error_code error;
  const fs::path folder = fs::canonical(path.parent_path(), error);
  if (error || folder != fmt::format("/proc/{}/fd", getpid())) return -1;
  const int stream = std::atoi(name.c_str());
  return stream == STDOUT_FILENO ? StandardOutput() : stream;
}

Target TargetOf(const std::string& file) {
  Target target;
  fs::path path = file;
  std::error_code error;
  for (int links = 0; links < kLinksMax; ++links) {
    target.stream = StreamCalled(path);
    if (target.stream >= 0) return target;
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  target.path = path;
  target.exists = stat(target.path.c_str(), &target.status) == 0;
  return target;
}

// Returns whether new content for `target` is written to a new file that then replaces it, and not
// written into the file itself (in place).  Devices and pipes are written in place, and so are
// files with several hard links, because the other names of such a file would keep the old content.
bool IsReplaced(const Target& target) {
  return !target.exists || (S_ISREG(target.status.st_mode) && target.status.st_nlink == 1);
}

std::string TemporaryName(const fs::path& beside, int number) {
  return beside.parent_path() / fmt::format(".openr-host-{}-{}.tmp", getpid(), number);
}

// Returns whether a file may be written in place after replacing it has failed with `error`.  This
// is possible if the system refuses to make a new file, but not if the disk is full.
bool MayBeInPlace(int error) {
  return error == EACCES || error == EPERM || error == EROFS || error == EBUSY;
}

// Gives the new file, open as `descriptor`, the owner and permissions of the file that it replaces,
// whose status is `old`.  Returns an errno, or 0.
int TakeOver(int descriptor, const struct stat& old) {
  struct stat now;
  if (fstat(descriptor, &now) != 0) return errno;
  const bool has_owner = now.st_uid == old.st_uid && now.st_gid == old.st_gid;
  if (!has_owner && fchown(descriptor, old.st_uid, old.st_gid) != 0) return EPERM;
  return fchmod(descriptor, old.st_mode & 07777) == 0 ? 0 : errno;
}

// Makes an empty file beside `target`, with the owner and permissions of `target`, and sets `name`
// to its path.  Returns the descriptor; after an error -1, sets `error` to the errno, and there is
// no such file.
int CreateBeside(const Target& target, std::string* name, int* error) {
  int descriptor = -1;
  for (int i = 0; descriptor < 0 && i < kTemporaryNamesMax; ++i) {
    *name = TemporaryName(target.path, i);
    descriptor = open(name->c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST) break;
  }
  *error = descriptor < 0 ? errno : target.exists ? TakeOver(descriptor, target.status) : 0;
  if (*error == 0) return descriptor;
  if (descriptor >= 0) {
    close(descriptor);
    unlink(name->c_str());
  }
  return -1;
}

// Writes `bytes` to a new file beside `target` and sets `name` to its path.  Returns 0, or an
// errno; after an error the new file does not exist.
int WriteBeside(const Target& target, std::string_view bytes, std::string* name) {
  int error = 0;
  const int descriptor = CreateBeside(target, name, &error);
  if (descriptor < 0) return error;
  error = WriteAll(descriptor, bytes);
  if (close(descriptor) != 0 && error == 0) error = errno;
  if (error != 0) unlink(name->c_str());
  return error;
}

// Returns an errno if the disk has no room for `size` bytes in the file open as `descriptor`, else
// 0.  Called before the old content of this file is touched, because a failure in the middle of
// writing would destroy it.
int WhyNoRoom(int descriptor, size_t size) {
  rlimit limit;
  if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && size > limit.rlim_cur) return EFBIG;
  if (fallocate(descriptor, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(size)) == 0) return 0;
  return errno == ENOSPC || errno == EDQUOT || errno == EFBIG ? errno : 0;
}

// Writes `bytes` to a device, a pipe, or a file that cannot be replaced.  Returns an errno, or 0.
int WriteInPlace(const Target& target, std::string_view bytes) {
  const bool is_file = target.exists && S_ISREG(target.status.st_mode);
  const int descriptor = open(target.path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const int room_error = is_file && !bytes.empty() ? WhyNoRoom(descriptor, bytes.size()) : 0;
  if (room_error != 0) {
    close(descriptor);
    return room_error;
  }
  const int error = WriteAll(descriptor, bytes);
  const bool is_cut = !is_file || ftruncate(descriptor, static_cast<off_t>(bytes.size())) == 0;
  const int cut_error = is_cut ? 0 : errno;
  const int close_error = close(descriptor) == 0 ? 0 : errno;
  return error != 0 ? error : cut_error != 0 ? cut_error : close_error;
}

}  // namespace

std::string WhyNotWritten(const std::string& file, int error) {
  if (error == ENOENT) return fmt::format("{}: cannot be written: there is no such folder", file);
  return fmt::format("{}: cannot be written: {}", file, std::strerror(error));
}

std::string WhyNotWritable(const std::string& file) {
  const Target target = TargetOf(file);
  if (target.stream >= 0) {
    const int flags = fcntl(target.stream, F_GETFL);
    const bool is_read_only = flags >= 0 && (flags & O_ACCMODE) == O_RDONLY;
    return flags >= 0 && !is_read_only ? "" : WhyNotWritten(file, EBADF);
  }
  if (target.exists) {
    if (S_ISDIR(target.status.st_mode)) return fmt::format("{}: is a folder; name a file", file);
    return access(target.path.c_str(), W_OK) == 0 ? "" : WhyNotWritten(file, errno);
  }
  // Creates the missing file for a moment, because only this shows whether the file can be created.
  const int descriptor = open(target.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return WhyNotWritten(file, errno);
  close(descriptor);
  unlink(target.path.c_str());
  return "";
}

bool IsStandardOutput(const std::string& file) { return TargetOf(file).stream == StandardOutput(); }

std::string WhyNoFolder(const std::string& folder) {
  if (folder.empty()) return "'' names no folder";
  std::error_code error;
  // After the loop below, the longest beginning of the path `folder` that exists.
  fs::path there = fs::absolute(folder, error).lexically_normal();
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_directory(there, error)) {
    return fs::equivalent(there, folder, error)
               ? fmt::format("{}: is a file; name a folder", folder)
               : fmt::format("{}: {} is a file, so nothing can be in it; name another folder",
                             folder, there.string());
  }
  if (access(there.c_str(), W_OK | X_OK) != 0) {
    return errno == EROFS
               ? fmt::format("{}: the disk of {} is mounted read-only; name another folder", folder,
                             there.string())
               : fmt::format("{}: you may not write in {}; name another folder", folder,
                             there.string());
  }
  // Creates a folder for a moment, because only this shows whether a folder can be created.  For
  // example, /proc lets root write, but creates no folder.
  const std::string probe = TemporaryName(there / "", 0);
  if (mkdir(probe.c_str(), 0700) != 0 && errno != EEXIST) {
    return fmt::format("{}: nothing can be made in {}: {}; name another folder", folder,
                       there.string(), std::strerror(errno));
  }
  rmdir(probe.c_str());
  return "";
}

std::string Explain(const fs::filesystem_error& error) {
  const fs::path& path = error.path2().empty() ? error.path1() : error.path2();
  const char* why = nullptr;
  switch (error.code().value()) {
    case ENOENT:
      why = "there is no such file or folder";
      break;
    case EEXIST:
      why = "is there already";
      break;
    case ENOTDIR:
      why = "a part of this name is a file, where a folder has to be; name another place";
      break;
    case EISDIR:
      why = "is a folder, where a file has to be";
      break;
    case EACCES:
    case EPERM:
      why = "you may not read or write there";
      break;
    case EROFS:
      why = "cannot be written: this disk is read-only";
      break;
    case ENOSPC:
    case EDQUOT:
      why = "no room is left on the disk";
      break;
    default:
      return fmt::format("{}: {}", path.string(), error.code().message());
  }
  return fmt::format("{}: {}", path.string(), why);
}

namespace {

std::string IsBeingWritten(const std::string& file, const struct stat& status) {
  return fmt::format("{}: is being written by {}; name another file, or wait for its end", file,
                     DescribeWriter(status));
}

// Returns the reason why `target` must not be replaced now, or "".  If a run were still writing its
// recording or console to the old file, that file would lose its name, and nobody could open it any
// more.
std::string WhyLocked(const std::string& file, const Target& target) {
  if (!target.exists || !S_ISREG(target.status.st_mode)) return "";
  const int descriptor = open(target.path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) return "";
  const bool is_locked = flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(descriptor);
  return is_locked ? IsBeingWritten(file, target.status) : "";
}

}  // namespace

PendingFile::PendingFile(PendingFile&& other) noexcept
    : file_(other.file_),
      bytes_(std::move(other.bytes_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, "")) {}

PendingFile::~PendingFile() {
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

std::string PendingFile::Write(std::string_view bytes) {
  const Target target = TargetOf(file_);
  bytes_ = bytes;
  target_ = target.path;
  if (target.stream >= 0) return "";
  if (target.exists && S_ISDIR(target.status.st_mode)) return WhyNotWritten(file_, EISDIR);
  if (target.exists && access(target_.c_str(), W_OK) != 0) return WhyNotWritten(file_, errno);
  if (const std::string problem = WhyLocked(file_, target); !problem.empty()) return problem;
  if (!IsReplaced(target)) return "";
  const int error = WriteBeside(target, bytes, &temporary_);
  if (error == 0) return "";
  temporary_.clear();
  return target.exists && MayBeInPlace(error) ? "" : WhyNotWritten(file_, error);
}

std::string PendingFile::Commit() {
  if (!temporary_.empty() && rename(temporary_.c_str(), target_.c_str()) == 0) {
    temporary_.clear();
    return "";
  }
  const bool is_refused = !temporary_.empty();
  if (is_refused && !MayBeInPlace(errno)) return WhyNotWritten(file_, errno);
  const Target target = TargetOf(file_);
  const int error =
      target.stream >= 0 ? WriteAll(target.stream, bytes_) : WriteInPlace(target, bytes_);
  return error == 0 ? "" : WhyNotWritten(file_, error);
}

std::string WriteFile(const std::string& file, std::string_view bytes) {
  PendingFile pending(file);
  const std::string problem = pending.Write(bytes);
  return problem.empty() ? pending.Commit() : problem;
}

void RemoveFile(const std::string& file) {
  const Target target = TargetOf(file);
  if (target.exists && S_ISREG(target.status.st_mode)) unlink(target.path.c_str());
}

std::string CopyToFile(const std::string& from, const std::string& to) {
  const std::optional<std::string> bytes = ReadFile(from);
  if (!bytes) return fmt::format("{}: cannot be read: {}", from, std::strerror(errno));
  const std::string problem = WriteFile(to, *bytes);
  if (!problem.empty()) return problem;
  std::error_code error;
  fs::permissions(to, fs::status(from).permissions(), error);
  return error ? WhyNotWritten(to, error.value()) : "";
}

namespace {

// Opens `target`, which `file` names, for writing, and locks it if it is a regular file.  Sets
// `status` to its status.  On failure returns -1 and sets `problem`.
int OpenLocked(const std::string& file, const Target& target, struct stat* status,
               std::string* problem) {
  const int descriptor =
      target.stream >= 0
          ? fcntl(target.stream, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)
          : open(target.path.c_str(), O_WRONLY | O_CREAT | O_NOCTTY | O_CLOEXEC, 0666);
  if (descriptor < 0 || fstat(descriptor, status) != 0) {
    *problem = WhyNotWritten(file, errno);
    if (descriptor >= 0) close(descriptor);
    return -1;
  }
  if (target.stream >= 0 || !S_ISREG(status->st_mode)) return descriptor;
  // Goes on without a lock if the file system has no locks.
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return descriptor;
  *problem = IsBeingWritten(file, *status);
  close(descriptor);
  return -1;
}

// Puts a new empty file in the place of `target`, which is locked and has the status `old`.
// Returns the descriptor of the new file, which is locked; after an error -1, and sets `error`.
int ReplaceLocked(const Target& target, const struct stat& old, int* error) {
  std::string name;
  const int descriptor = CreateBeside(target, &name, error);
  if (descriptor < 0) return -1;
  flock(descriptor, LOCK_EX | LOCK_NB);
  // Looks whether the path still leads to the old file, because another process may have replaced
  // it before it was locked here.
  struct stat now;
  const bool is_same =
      stat(target.path.c_str(), &now) == 0 && now.st_ino == old.st_ino && now.st_dev == old.st_dev;
  if (is_same && rename(name.c_str(), target.path.c_str()) == 0) return descriptor;
  *error = is_same ? errno : EAGAIN;
  close(descriptor);
  unlink(name.c_str());
  return -1;
}

}  // namespace

int OpenGrowingFile(const std::string& file, std::string* problem) {
  const Target target = TargetOf(file);
  struct stat status;
  const int descriptor = OpenLocked(file, target, &status, problem);
  if (descriptor < 0 || target.stream >= 0 || !S_ISREG(status.st_mode)) return descriptor;
  if (ftruncate(descriptor, 0) == 0) return descriptor;
  *problem = WhyNotWritten(file, errno);
  close(descriptor);
  return -1;
}

int OpenNewGrowingFile(const std::string& file, std::string* problem) {
  const Target target = TargetOf(file);
  if (target.stream >= 0 || !target.exists || !IsReplaced(target))
    return OpenGrowingFile(file, problem);
  struct stat status;
  const int old = OpenLocked(file, target, &status, problem);
  if (old < 0) return -1;
  int error = 0;
  const int descriptor = ReplaceLocked(target, status, &error);
  close(old);
  if (descriptor >= 0) return descriptor;
  if (MayBeInPlace(error)) return OpenGrowingFile(file, problem);
  *problem = WhyNotWritten(file, error);
  return -1;
}

int WriteAll(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<size_t>(written));
    } else if (errno == EAGAIN) {  // another process has made the stream non-blocking, so we wait
      pollfd ready = {descriptor, POLLOUT, 0};
      poll(&ready, 1, -1);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

PreparedFile::PreparedFile(const std::string& file) {
  if (file.empty()) return;
  const Target target = TargetOf(file);
  stream_ = target.stream;
  if (target.path.size() >= kPathBytes) return;
  target.path.copy(target_, kPathBytes - 1);
  const std::string temporary = TemporaryName(target.path, kTemporaryNamesMax);
  const bool is_own = !target.exists || target.status.st_uid == geteuid();
  if (!IsReplaced(target) || !is_own || temporary.size() >= kPathBytes) return;
  temporary.copy(temporary_, kPathBytes - 1);
  keeps_mode_ = target.exists;
  if (keeps_mode_) mode_ = target.status.st_mode & 0777;
}

// Opens the file by direct system calls, because open() and rename() in this process are functions
// of the program, which may act for an object on a file of its Memory Stick.
int PreparedFile::Open() {
  if (stream_ >= 0) return stream_;
  if (target_[0] == 0) return -1;
  const auto open_file = [this](const char* name, int flags) {
    return static_cast<int>(syscall(SYS_openat, AT_FDCWD, name, O_WRONLY | O_CREAT | flags, mode_));
  };
  if (temporary_[0] != 0) descriptor_ = open_file(temporary_, O_EXCL);
  if (descriptor_ >= 0 && keeps_mode_) syscall(SYS_fchmod, descriptor_, mode_);
  if (descriptor_ < 0) {
    temporary_[0] = 0;
    descriptor_ = open_file(target_, O_TRUNC);
  }
  return descriptor_;
}

void PreparedFile::Close() {
  if (descriptor_ < 0) return;
  syscall(SYS_close, descriptor_);
  if (temporary_[0] != 0) syscall(SYS_renameat2, AT_FDCWD, temporary_, AT_FDCWD, target_, 0);
  descriptor_ = -1;
}

}  // namespace openr_host
