// The folder that a run uses as its Memory Stick.
//
// A stick that a person has named is used as it is: what objects write is there afterwards, and so
// is the record of a crash.  The default stick, which came with the program and is that of every
// run without --stick, is never written: such a run gets a copy of its own, gone at its end, and
// the record of a crash goes to the program's cache folder.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "runtime/base/temp_folder.h"

namespace openr_host {

class RunStick {
 public:
  // `wanted`: the folder that was named, "" for none.  `is_written`: objects may write on it; one
  // that is only read needs no copy.  Throws std::runtime_error.
  RunStick(const std::string& wanted, bool is_written);

  // The stick that people and recordings name: another run finds the same files there.
  const std::string& name() const { return name_; }

  // Where the files of this run are.
  const std::string& folder() const { return folder_; }

  // The file for the record of a crash; it is possible that it cannot be written.
  const std::string& crash_log() const { return crash_log_; }

  // Whether the run uses the default stick: the crash record is in the cache folder then, and
  // findings name the file.
  bool is_default() const { return is_default_; }

 private:
  const bool is_default_;
  const std::string name_;
  std::unique_ptr<TempFolder> copy_;
  std::string folder_;
  std::string crash_log_;
};

// The file for the record of a crash on the stick in `folder`.
std::string CrashLogOn(const std::string& folder);

// Copies the stick `from` to the folder `to`, which is there and empty.  Files may be written
// there, whoever owns the original; debug information, which is large and only read, becomes a
// link. Throws std::filesystem::filesystem_error.
void CopyStick(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace openr_host
