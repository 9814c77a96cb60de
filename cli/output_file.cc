#include "cli/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <utility>

#include "cli/file_lock.h"
#include "cli/output_target.h"
#include "cli/standard_streams.h"
#include "runtime/base/read_file.h"

namespace openr_host {

namespace fs = std::filesystem;

namespace {

// Writes `bytes` to a new file beside `target` and sets `name` to its path.  Returns 0.  After an
// error, removes the new file and returns the errno.
int WriteBeside(const OutputTarget& target, std::string_view bytes, std::string* name) {
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
int RoomError(int descriptor, size_t size) {
  rlimit limit;
  if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && size > limit.rlim_cur) return EFBIG;
  if (fallocate(descriptor, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(size)) == 0) return 0;
  return errno == ENOSPC || errno == EDQUOT || errno == EFBIG ? errno : 0;
}

// Writes `bytes` to a device, a pipe, or a file that cannot be replaced.  Returns an errno, or 0.
int WriteInPlace(const OutputTarget& target, std::string_view bytes) {
  const bool is_file = target.exists && S_ISREG(target.status.st_mode);
  const int descriptor = open(target.path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const int room_error = is_file && !bytes.empty() ? RoomError(descriptor, bytes.size()) : 0;
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

std::string WriteErrorText(const std::string& file, int error) {
  if (error == ENOENT) return fmt::format("{}: cannot be written: there is no such folder", file);
  return fmt::format("{}: cannot be written: {}", file, std::strerror(error));
}

std::string FileWriteProblem(const std::string& file) {
  const OutputTarget target = OutputTargetOf(file);
  if (target.stream >= 0) {
    const int flags = fcntl(target.stream, F_GETFL);
    const bool is_read_only = flags >= 0 && (flags & O_ACCMODE) == O_RDONLY;
    return flags >= 0 && !is_read_only ? "" : WriteErrorText(file, EBADF);
  }
  if (target.exists) {
    if (S_ISDIR(target.status.st_mode)) return fmt::format("{}: is a folder; name a file", file);
    return access(target.path.c_str(), W_OK) == 0 ? "" : WriteErrorText(file, errno);
  }
  // Creates the missing file for a moment, because only this shows whether the file can be created.
  const int descriptor = open(target.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return WriteErrorText(file, errno);
  close(descriptor);
  unlink(target.path.c_str());
  return "";
}

bool IsStandardOutput(const std::string& file) {
  return OutputTargetOf(file).stream == StandardOutput();
}

std::string FolderWriteProblem(const std::string& folder) {
  if (folder.empty()) return "'' names no folder";
  std::error_code error;
  // The folder in which a missing `folder` would be made.  The loop below goes up from `folder`
  // until it finds a path that exists.
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

// Returns the reason why `target` must not be replaced now, or "".  A file that a run is still
// writing, such as its recording, must not be replaced: the run would go on writing to the old
// file, which has no name any more, and the recording would be lost.
std::string LockProblem(const std::string& file, const OutputTarget& target) {
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
  const OutputTarget target = OutputTargetOf(file_);
  bytes_ = bytes;
  target_ = target.path;
  if (target.stream >= 0) return "";
  if (target.exists && S_ISDIR(target.status.st_mode)) return WriteErrorText(file_, EISDIR);
  if (target.exists && access(target_.c_str(), W_OK) != 0) return WriteErrorText(file_, errno);
  if (const std::string problem = LockProblem(file_, target); !problem.empty()) return problem;
  if (!IsReplaced(target)) return "";
  const int error = WriteBeside(target, bytes, &temporary_);
  if (error == 0) return "";
  temporary_.clear();
  return target.exists && MayBeInPlace(error) ? "" : WriteErrorText(file_, error);
}

std::string PendingFile::Commit() {
  if (!temporary_.empty() && rename(temporary_.c_str(), target_.c_str()) == 0) {
    temporary_.clear();
    return "";
  }
  const bool is_refused = !temporary_.empty();
  if (is_refused && !MayBeInPlace(errno)) return WriteErrorText(file_, errno);
  const OutputTarget target = OutputTargetOf(file_);
  const int error =
      target.stream >= 0 ? WriteAll(target.stream, bytes_) : WriteInPlace(target, bytes_);
  return error == 0 ? "" : WriteErrorText(file_, error);
}

std::string WriteFile(const std::string& file, std::string_view bytes) {
  PendingFile pending(file);
  const std::string problem = pending.Write(bytes);
  return problem.empty() ? pending.Commit() : problem;
}

void RemoveFile(const std::string& file) {
  const OutputTarget target = OutputTargetOf(file);
  if (target.exists && S_ISREG(target.status.st_mode)) unlink(target.path.c_str());
}

std::string CopyToFile(const std::string& from, const std::string& to) {
  const std::optional<std::string> bytes = ReadFile(from);
  if (!bytes) return fmt::format("{}: cannot be read: {}", from, std::strerror(errno));
  const std::string problem = WriteFile(to, *bytes);
  if (!problem.empty()) return problem;
  // Copies the permissions only to a regular file.  A device, a pipe or an open stream has
  // received the content, but is no copy of `from`.
  const OutputTarget target = OutputTargetOf(to);
  if (target.stream >= 0 || !S_ISREG(target.status.st_mode)) return "";
  std::error_code error;
  fs::permissions(to, fs::status(from).permissions(), error);
  return error ? WriteErrorText(to, error.value()) : "";
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

}  // namespace openr_host
