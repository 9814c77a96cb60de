#include "runtime/base/temp_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/statvfs.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr char kMemoryFolder[] = "/dev/shm";

constexpr std::string_view kBegin = "openr-host-run-";

// Returns the prefix of the names of our temporary folders.  The prefix contains the number of the
// PID namespace, because containers may share the folder of temporary files, but number their
// processes separately.  Without this number, a process could remove a folder that another
// container uses, because the process id in the folder's name does not exist in its own container.
std::string Prefix() {
  std::error_code error;
  std::string space = fs::read_symlink("/proc/self/ns/pid", error).string();
  std::erase_if(space, [](unsigned char c) { return std::isdigit(c) == 0; });
  return fmt::format("{}{}-", kBegin, space);
}

// Opens the folder `path` and locks it.  Returns the descriptor, or -1 with errno set: EWOULDBLOCK
// if another process has locked the folder.  The process that makes a folder locks it.  The lock
// ends when that process and all its forks have ended or have closed the descriptor.
int Lock(const std::string& path) {
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
  if (folder < 0 || flock(folder, LOCK_EX | LOCK_NB) == 0) return folder;
  const int why = errno;
  close(folder);
  errno = why;
  return -1;
}

// Returns whether other computers may use the file system of `folder`, too.  Locks of other
// computers may be invisible here, so a folder without a lock may still be in use.
bool IsOnNetwork(const fs::path& folder) {
  constexpr uint32_t kCifs = 0xff534d42;  // not in linux/magic.h
  struct statfs facts {};
  if (statfs(folder.c_str(), &facts) != 0) return true;
  const auto type = static_cast<uint32_t>(facts.f_type);
  return type == NFS_SUPER_MAGIC || type == V9FS_MAGIC || type == FUSE_SUPER_MAGIC ||
         type == SMB2_SUPER_MAGIC || type == kCifs;
}

// Removes the temporary folders of processes that no longer exist.  The name of a folder of this
// PID namespace begins with `prefix`, and continues with the process id and a random ending.
void RemoveStaleFolders(const fs::path& parent, const std::string& prefix) {
  const bool is_on_network = IsOnNetwork(parent);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(parent, error)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(kBegin)) continue;
    // Keeps the folder of a process that exists, if the process belongs to this PID namespace.
    // Process ids of other namespaces mean nothing here, so for their folders only the lock shows
    // whether a folder is in use.
    const bool is_ours = name.starts_with(prefix);
    const int pid = is_ours ? std::atoi(name.c_str() + prefix.size()) : 0;
    if (is_ours && (pid <= 0 || kill(pid, 0) == 0 || errno != ESRCH)) continue;
    if (!is_ours && is_on_network) continue;
    const int folder = Lock(entry.path());
    // Keeps a folder that another process has locked.  Lock() may also fail for another reason,
    // such as a file system without locks.  Then only a folder of this PID namespace is removed,
    // because its process is known to have ended.
    if (folder < 0 && (!is_ours || errno == EWOULDBLOCK)) continue;
    fs::remove_all(entry.path(), error);
    if (folder >= 0) close(folder);
  }
}

// Makes a new folder whose name begins with `begin`, and locks it.  Sets `*lock` to the descriptor
// that holds the lock.  Returns the path of the folder, or "" with errno set.
std::string MakeLockedFolder(const std::string& begin, int* lock) {
  for (;;) {
    std::string path = begin + "XXXXXX";
    if (mkdtemp(path.data()) == nullptr) return "";
    *lock = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (*lock < 0 && errno != ENOENT) {
      const int why = errno;
      rmdir(path.c_str());
      errno = why;
      return "";
    }
    // A file system may have no locks (ENOLCK and others).  The folder is then used without a lock.
    const bool is_taken =
        *lock >= 0 && flock(*lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    // Returns the folder if it still exists and no other process has locked it.  Otherwise makes
    // another folder: before this process locked the first one, another process may have taken it
    // for a stale folder, and may have locked or removed it.
    if (*lock >= 0 && !is_taken && access(path.c_str(), F_OK) == 0) return path;
    if (*lock >= 0) close(std::exchange(*lock, -1));
  }
}

// Moves `descriptor` to a number that is free and at least 500, if the limit of descriptors allows
// this.  Objects see the numbers of their descriptors, and these must not depend on how many
// temporary folders the runtime has.
int MoveUp(int descriptor) {
  constexpr int kLeast = 500;
  const int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, kLeast);
  if (moved < 0) return descriptor;
  close(descriptor);
  return moved;
}

// Returns whether small temporary files may be kept in kMemoryFolder (/dev/shm), which is in the
// host's memory and not on its disk.
bool MayUseMemory() {
  constexpr uint64_t kFreeBytes = uint64_t{1} << 30;  // enough for the images of 1000 robots
  struct statvfs facts {};
  return std::getenv("TMPDIR") == nullptr && statvfs(kMemoryFolder, &facts) == 0 &&
         (facts.f_flag & (ST_NOEXEC | ST_RDONLY)) == 0 &&
         uint64_t{facts.f_bavail} * facts.f_frsize >= kFreeBytes &&
         access(kMemoryFolder, W_OK | X_OK) == 0;
}

fs::path ParentFor(TempUse use) {
  if (use == TempUse::kSmallFiles && MayUseMemory()) return kMemoryFolder;
  return TemporaryFiles();
}

}  // namespace

std::string TemporaryFiles() {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  if (!error) return place.string();
  // Finds the environment variable with the wrong folder, for the error message.  The C++ library
  // looks for these variables in this order, and its own error names none of them.
  for (const char* const variable : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"}) {
    const char* const value = std::getenv(variable);
    if (value == nullptr) continue;
    if (*value == 0) {
      throw std::runtime_error(fmt::format(
          "the environment variable {} is empty; set it to a folder, or unset it", variable));
    }
    throw std::runtime_error(
        fmt::format("{}: is no folder for temporary files, but the environment variable {} names "
                    "it; set {} to a folder that exists, or unset it",
                    value, variable, variable));
  }
  throw std::runtime_error(
      "/tmp: is no folder; the environment variable TMPDIR names another place for temporary "
      "files");
}

TempFolder::TempFolder(TempUse use) : process_(getpid()) {
  std::error_code error;
  const fs::path parent = ParentFor(use);
  const std::string prefix = Prefix();
  RemoveStaleFolders(parent, prefix);
  // Removes stale folders in memory too, even if the new folder will not be in memory, because
  // stale folders take memory that other programs need.
  if (parent != kMemoryFolder) RemoveStaleFolders(kMemoryFolder, prefix);
  const std::string begin = (parent / fmt::format("{}{}-", prefix, process_)).string();
  path_ = MakeLockedFolder(begin, &lock_);
  if (path_.empty()) {
    const std::string why = std::strerror(errno);
    throw std::runtime_error(fmt::format(
        "{}: no temporary folder can be made there: {}; the environment variable TMPDIR names "
        "another place for them",
        fs::absolute(parent, error).string(), why));
  }
  lock_ = MoveUp(lock_);
}

TempFolder::~TempFolder() {
  std::error_code error;
  if (process_ == getpid()) fs::remove_all(path_, error);
  close(lock_);
}

}  // namespace openr_host
