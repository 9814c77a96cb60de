#include "cli/growing_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>

#include "cli/file_lock.h"
#include "cli/output_file.h"
#include "cli/output_target.h"

namespace openr_host {
namespace {

// Opens `target`, the file or stream that the name `file` means, for writing.  Locks it if it is a
// regular file.  Returns the descriptor, and sets `status` to the status of the open file.  On
// failure returns -1 and sets `problem`.
int OpenLocked(const std::string& file, const OutputTarget& target, struct stat* status,
               std::string* problem) {
  const int descriptor =
      target.stream >= 0
          ? fcntl(target.stream, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)
          : open(target.path.c_str(), O_WRONLY | O_CREAT | O_NOCTTY | O_CLOEXEC, 0666);
  if (descriptor < 0 || fstat(descriptor, status) != 0) {
    *problem = WriteErrorText(file, errno);
    if (descriptor >= 0) close(descriptor);
    return -1;
  }
  if (target.stream >= 0 || !S_ISREG(status->st_mode)) return descriptor;
  // If the file system has no locks, goes on without a lock, because the file can be written all
  // the same.
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return descriptor;
  *problem = IsBeingWritten(file, *status);
  close(descriptor);
  return -1;
}

// Puts a new empty file in the place of `target`, which is locked and has the status `old`.
// Returns the descriptor of the new file, which is locked.  If this fails, returns -1, sets `error`
// to the errno, and leaves `target` as it was.
int ReplaceLocked(const OutputTarget& target, const struct stat& old, int* error) {
  std::string name;
  const int descriptor = CreateBeside(target, &name, error);
  if (descriptor < 0) return -1;
  flock(descriptor, LOCK_EX | LOCK_NB);
  // Tests whether the path still leads to the old file, because another process may have replaced
  // the old file before the caller has locked it.
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
  const OutputTarget target = OutputTargetOf(file);
  struct stat status;
  const int descriptor = OpenLocked(file, target, &status, problem);
  if (descriptor < 0 || target.stream >= 0 || !S_ISREG(status.st_mode)) return descriptor;
  if (ftruncate(descriptor, 0) == 0) return descriptor;
  *problem = WriteErrorText(file, errno);
  close(descriptor);
  return -1;
}

int OpenNewGrowingFile(const std::string& file, std::string* problem) {
  const OutputTarget target = OutputTargetOf(file);
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
  *problem = WriteErrorText(file, error);
  return -1;
}

GrowingFile::GrowingFile(const std::string& file) : file_(file) {
  std::string problem;
  descriptor_ = OpenGrowingFile(file, &problem);
  if (descriptor_ < 0) throw std::runtime_error(problem);
  can_go_back_ = lseek(descriptor_, 0, SEEK_CUR) >= 0;
}

GrowingFile::~GrowingFile() { close(descriptor_); }

void GrowingFile::Append(std::string_view bytes, std::string_view end) {
  if (error_ != 0) return;
  if (!can_go_back_) end = "";
  const auto go_back = [this] { lseek(descriptor_, static_cast<off_t>(size_), SEEK_SET); };
  if (!end_.empty()) go_back();
  // Writes `bytes` and `end` in one call, because the process may be killed between two calls.
  error_ = end.empty() ? WriteAll(descriptor_, bytes)
                       : WriteAll(descriptor_, std::string(bytes).append(end));
  if (error_ == 0) {
    const bool is_shorter = bytes.size() + end.size() < end_.size();
    size_ += bytes.size();
    end_ = end;
    if (!is_shorter) return;
  } else if (!end_.empty()) {
    // Goes back to the place of the old `end_`, the text that completes the file, and writes `end_`
    // once more, because the failed write may have overwritten it with a part of `bytes`.
    go_back();
    WriteAll(descriptor_, end_);
  }
  // Cuts off the bytes behind `end_`.  There are such bytes if a write has failed, or if the old
  // `end_` was longer than the `bytes` and `end` that were written over it.  A device or a pipe
  // cannot be shortened, so a failure is ignored.
  [[maybe_unused]] const int result =
      ftruncate(descriptor_, static_cast<off_t>(size_ + end_.size()));
}

std::string GrowingFile::Problem() const {
  if (error_ == 0) return "";
  return WriteErrorText(file_, error_);
}

}  // namespace openr_host
