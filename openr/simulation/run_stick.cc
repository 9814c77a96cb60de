#include "openr/simulation/run_stick.h"

#include <stdexcept>

#include "cli/cache_folder.h"
#include "cli/copy_file.h"
#include "cli/output_file.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/spelling.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr char kCrashLog[] = "EMON.LOG";

// Returns the path of the file for the crash record in the program's cache folder, and creates the
// folder.  Ignores an error, because most runs write no crash record.  If a crash comes after such
// an error, writing the record fails as well, and the program then says why.
std::string CrashLogInCache() {
  const fs::path folder = CacheFolder();
  std::error_code error;
  fs::create_directories(folder, error);
  return folder / kCrashLog;
}

}  // namespace

// Looks for the folder OPEN-R with Locate(), because Locate() also finds a folder "open-r"
// (HoldsOpenR()).
std::string CrashLogOn(const std::string& folder) {
  const fs::path root = fs::absolute(folder);
  const MemoryStick::Location open_r = FolderStick(root).Locate("/MS/OPEN-R");
  const fs::path parent = open_r.exists ? fs::path(open_r.path) : root / "OPEN-R";
  return (parent / kCrashLog).lexically_normal();
}

void CopyStick(const fs::path& from, const fs::path& to) {
  for (const auto& entry : fs::directory_iterator(from)) {
    const fs::path copy = to / entry.path().filename();
    if (entry.is_directory()) {
      fs::create_directory(copy);
      CopyStick(entry.path(), copy);
    } else if (EqualsIgnoringCase(entry.path().extension().string(), ".DBG")) {
      // A link is enough for debug information, because no object writes it.
      fs::create_symlink(fs::canonical(entry.path()), copy);
    } else {
      CopyFile(entry.path(), copy);
      // Lets the owner write to the copy, because objects write to it and the files of an installed
      // stick may be read-only.
      fs::permissions(copy, fs::perms::owner_write, fs::perm_options::add);
    }
  }
}

RunStick::RunStick(const std::string& wanted, bool is_written)
    : is_default_(wanted.empty()), name_(StickFolder(wanted)), folder_(name_) {
  crash_log_ = is_default_ ? CrashLogInCache() : CrashLogOn(name_);
  if (!is_default_ || !is_written) return;
  copy_ = std::make_unique<TempFolder>();
  try {
    CopyStick(name_, copy_->path());
  } catch (const fs::filesystem_error& error) {
    throw std::runtime_error(Explain(error) +
                             "; a run without --stick works on a copy of the default stick, and "
                             "the environment variable TMPDIR names another place for it");
  }
  folder_ = copy_->path();
}

}  // namespace openr_host
