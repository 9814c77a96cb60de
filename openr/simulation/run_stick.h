// The folder that a run uses as its Memory Stick.
//
// A stick that the user has named is used directly: objects write to it, and so does the record of
// a crash.  The default stick came with the program and is used by every run without --stick, so it
// is never written to: such a run gets a copy, which is removed at its end, and the record of a
// crash goes to the program's cache folder.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "runtime/base/temp_folder.h"

namespace openr_host {

class RunStick {
 public:
  // `wanted` is the folder that the user has named; "": none, so the default stick is meant.  If
  // `is_written`, objects may write to the stick, so a run on the default stick gets a copy of its
  // own.  Throws std::runtime_error.
  RunStick(const std::string& wanted, bool is_written);

  // Returns the folder to name in messages and recordings, in which another run finds the same
  // files.
  const std::string& name() const { return name_; }

  // Returns the folder with the files of this run.
  const std::string& folder() const { return folder_; }

  // Returns the file for the record of a crash.  It may not be writable.
  const std::string& crash_log() const { return crash_log_; }

  // Returns whether the run uses the default stick.  The crash record of such a run is in the cache
  // folder, where users would not look, so findings name its path.
  bool is_default() const { return is_default_; }

 private:
  const bool is_default_;
  const std::string name_;
  std::unique_ptr<TempFolder> copy_;
  std::string folder_;
  std::string crash_log_;
};

// Returns the file for the record of a crash on the stick in `folder`.
std::string CrashLogOn(const std::string& folder);

// Copies the stick `from` to the folder `to`, which exists and is empty.  The copies can be written
// to, whoever owns the originals.  Debug information is large and only read, so a link to it is
// made instead.  Throws std::filesystem::filesystem_error.
void CopyStick(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace openr_host
