// TempFolder: a folder for files that only this process needs, in the host's folder for temporary
// files.
#pragma once

#include <string>

namespace openr_host {

// Returns the host's folder for temporary files, which TMPDIR may name.  If this folder does not
// exist, throws std::runtime_error with a text that names the wrong environment variable.
std::string TemporaryFiles();

enum class TempUse {
  kAnyFiles,
  // Files that are few and small.  They are kept in memory (/dev/shm) if three conditions hold:
  // TMPDIR is not set, /dev/shm has room, and files there may be executed.  A run makes and removes
  // dozens of small files.  On a disk this takes longer than everything else at the start of the
  // run.
  kSmallFiles,
};

// Makes a folder and removes it in the destructor.  A fork of the process that made the folder does
// not remove it.  A killed process leaves its folder behind, so the constructor also removes the
// folders of processes that no longer exist.  A folder is locked as long as its process or a fork
// of its process exists.  For a process in another container only this lock shows that its folder
// is in use, because process ids of other containers mean nothing here.
class TempFolder {
 public:
  // Makes the folder.  If that fails, throws std::runtime_error with the place and the system's
  // reason.
  explicit TempFolder(TempUse use = TempUse::kAnyFiles);
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  const int process_;
  int lock_ = -1;  // descriptor that holds the lock of the folder
};

}  // namespace openr_host
