#include "openr/run/stick_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "cli/file_lock.h"

namespace openr_host {

StickLock::StickLock(const std::string& folder) {
  if (folder.empty()) return;
  descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // Ignores all other errors, because some file systems have no locks, and a run needs none.
  if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  struct stat status {};
  if (fstat(descriptor_, &status) != 0) return;
  note_ = fmt::format(
      "{} runs on the stick {}, too: both write to it, and uploads to one can break uploads to the "
      "other; give this run a copy of the stick",
      DescribeWriter(status), folder);
}

StickLock::~StickLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace openr_host
