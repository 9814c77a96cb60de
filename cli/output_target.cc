#include "cli/output_target.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>

#include "cli/standard_streams.h"

namespace openr_host {

namespace fs = std::filesystem;

namespace {

constexpr int kLinksMax = 40;  // longest chain of symbolic links; the kernel has the same limit

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

// Gives the new file, open as `descriptor`, the owner and permissions of the file that it replaces,
// whose status is `old`.  Returns an errno, or 0.
int CopyOwnerAndMode(int descriptor, const struct stat& old) {
  struct stat now;
  if (fstat(descriptor, &now) != 0) return errno;
  const bool has_owner = now.st_uid == old.st_uid && now.st_gid == old.st_gid;
  if (!has_owner && fchown(descriptor, old.st_uid, old.st_gid) != 0) return EPERM;
  return fchmod(descriptor, old.st_mode & 07777) == 0 ? 0 : errno;
}

}  // namespace

OutputTarget OutputTargetOf(const std::string& file) {
  OutputTarget target;
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

bool IsReplaced(const OutputTarget& target) {
  return !target.exists || (S_ISREG(target.status.st_mode) && target.status.st_nlink == 1);
}

std::string TemporaryName(const fs::path& beside, int number) {
  return beside.parent_path() / fmt::format(".openr-host-{}-{}.tmp", getpid(), number);
}

bool MayBeInPlace(int error) {
  return error == EACCES || error == EPERM || error == EROFS || error == EBUSY;
}

int CreateBeside(const OutputTarget& target, std::string* name, int* error) {
  int descriptor = -1;
  for (int i = 0; descriptor < 0 && i < kTemporaryNamesMax; ++i) {
    *name = TemporaryName(target.path, i);
    descriptor = open(name->c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST) break;
  }
  *error = descriptor < 0 ? errno : target.exists ? CopyOwnerAndMode(descriptor, target.status) : 0;
  if (*error == 0) return descriptor;
  if (descriptor >= 0) {
    close(descriptor);
    unlink(name->c_str());
  }
  return -1;
}

}  // namespace openr_host
