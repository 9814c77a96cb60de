#include "runtime/base/temp_folder.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr char kMemoryFolder[] = "/dev/shm";

// Returns the prefix of the names of our temporary folders.  The prefix contains the number of the
// PID namespace.  Containers may share the folder of temporary files but count their processes
// separately.  So a process id alone does not show whether the folder belongs to a living process
// of another container, which must keep its folder.
std::string Prefix() {
  std::error_code error;
  std::string space = fs::read_symlink("/proc/self/ns/pid", error).string();
  std::erase_if(space, [](unsigned char c) { return std::isdigit(c) == 0; });
  return fmt::format("openr-host-run-{}-", space);
}

// Removes the temporary folders of processes that no longer exist.  The name of such a folder is
// `prefix`, the process id and a random ending.
void RemoveStaleFolders(const fs::path& parent, const std::string& prefix) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(parent, error)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(prefix)) continue;
    const int pid = std::atoi(name.c_str() + prefix.size());
    if (pid > 0 && kill(pid, 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), error);
  }
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
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  return error ? "." : parent;
}

}  // namespace

TempFolder::TempFolder(TempUse use) : process_(getpid()) {
  std::error_code error;
  const fs::path parent = ParentFor(use);
  const std::string prefix = Prefix();
  RemoveStaleFolders(parent, prefix);
  // Removes stale folders in memory too, even if the new folder will not be in memory, because
  // stale folders take memory that other programs need.
  if (parent != kMemoryFolder) RemoveStaleFolders(kMemoryFolder, prefix);
  std::string name = (parent / fmt::format("{}{}-XXXXXX", prefix, process_)).string();
  if (mkdtemp(name.data()) == nullptr) {
    const std::string why = std::strerror(errno);
    throw std::runtime_error(fmt::format(
        "{}: no temporary folder can be made there: {}; the environment variable TMPDIR names "
        "another place for them",
        fs::absolute(parent, error).string(), why));
  }
  path_ = name;
}

TempFolder::~TempFolder() {
  std::error_code error;
  if (process_ == getpid()) fs::remove_all(path_, error);
}

}  // namespace openr_host
