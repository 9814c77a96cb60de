#include "runtime/core/temp_folder.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr char kPrefix[] = "openr-host-run-";

// Removes folders of processes that are gone.
void RemoveStaleFolders(const fs::path& parent) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(parent, error)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(kPrefix)) continue;
    const int pid = std::atoi(name.c_str() + sizeof kPrefix - 1);
    if (pid > 0 && kill(pid, 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), error);
  }
}

}  // namespace

TempFolder::TempFolder() : process_(getpid()) {
  std::error_code error;
  fs::path parent = fs::temp_directory_path(error);
  if (error) parent = ".";
  RemoveStaleFolders(parent);
  std::string name = (parent / fmt::format("{}{}-XXXXXX", kPrefix, process_)).string();
  if (mkdtemp(name.data()) != nullptr) path_ = name;
}

TempFolder::~TempFolder() {
  std::error_code error;
  if (!path_.empty() && process_ == getpid()) fs::remove_all(path_, error);
}

}  // namespace openr_host
