// RunStick, the folder that a run uses as its Memory Stick.
//
// If the user has named a stick, objects write to this stick, and a crash record is written there,
// too.  Without --stick, runs use the default stick, which came with the program and must not
// change.  So such a run gets a copy of the default stick, which is removed at the end of the run.
// Its crash record goes to the program's cache folder.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "runtime/base/temp_folder.h"

namespace openr_host {

class RunStick {
 public:
  // Chooses the folder: `wanted` is the folder of the user's stick; "": the default stick.
  // `is_written` says that objects may write to the stick; then the default stick is copied.
  // Throws std::runtime_error if `wanted` is not the folder of a stick, or if the default stick
  // cannot be copied.
  RunStick(const std::string& wanted, bool is_written);

  // Returns the folder of the original stick, for messages and recordings.  Unlike the copy that
  // the run may use, it still exists after the run.
  const std::string& name() const { return name_; }

  // Returns the folder that this run uses as its stick: the original stick or the copy of the
  // default stick.
  const std::string& folder() const { return folder_; }

  // Returns the path of the file for a crash record.  The file is written only when a crash comes;
  // if it cannot be written, openr says why on standard error.
  const std::string& crash_log() const { return crash_log_; }

  // Returns whether the run uses the default stick.  Then the crash record is in the cache folder,
  // where users would not look, so findings name its path.
  bool is_default() const { return is_default_; }

 private:
  const bool is_default_;
  const std::string name_;
  std::unique_ptr<TempFolder> copy_;
  std::string folder_;
  std::string crash_log_;
};

// Returns the path of the file for a crash record on the stick in `folder`.
std::string CrashLogOn(const std::string& folder);

// Copies the stick `from` to the existing, empty folder `to`.  The owner can write to all copied
// files, even if the originals are read-only.  Debug information (.DBG) is large and is only read,
// so it is linked instead of copied.  Throws std::filesystem::filesystem_error if a file cannot be
// copied.
void CopyStick(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace openr_host
