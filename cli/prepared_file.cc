#include "cli/prepared_file.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "cli/output_target.h"

namespace openr_host {

PreparedFile::PreparedFile(const std::string& file) {
  if (file.empty()) return;
  const OutputTarget target = OutputTargetOf(file);
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

// Opens the file by direct system calls, because open() and rename() are hooks of the runtime in
// this process.  These hooks may look for the file on an object's Memory Stick.
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
