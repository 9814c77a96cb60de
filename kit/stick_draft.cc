#include "kit/stick_draft.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "cli/copy_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

}  // namespace

StickDraft::StickDraft(const std::string& output)
    // Adds a slash and takes the parent, so that "out" and "out/" become the same path.
    : output_((fs::absolute(output) / "").lexically_normal().parent_path()) {
  std::error_code error;
  if (fs::exists(fs::symlink_status(output_, error))) {
    throw std::runtime_error(
        fmt::format("{} is there already; name a new folder, nothing is written over", output));
  }
  fs::create_directories(output_.parent_path());
  // Makes the temporary folder beside the output, because Finish() can rename a folder only inside
  // one file system.
  std::string pattern = output_.parent_path() / ".openr-stick-XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error(fmt::format("{}: cannot make a folder there: {}",
                                         output_.parent_path().string(), std::strerror(errno)));
  }
  folder_ = pattern;
  fs::permissions(folder_, fs::perms(0755));
  for (const fs::path& part : {stick(), work()}) fs::create_directory(part);
}

StickDraft::~StickDraft() {
  std::error_code error;
  fs::remove_all(folder_, error);
}

void StickDraft::Finish() { fs::rename(stick(), output_); }

void CopyTree(const fs::path& from, const fs::path& to) {
  CopyFolder(from, to);
  for (const auto& entry : fs::recursive_directory_iterator(to))
    fs::permissions(entry, fs::perms::owner_write, fs::perm_options::add);
}

}  // namespace openr_host
