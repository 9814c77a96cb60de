// TempFolder: a folder for files that only this process needs, in the host's folder for temporary
// files.
#pragma once

#include <string>

namespace openr_host {

// Makes a folder and removes it in the destructor.  Only the process that made the folder removes
// it; a fork of that process does not.  A killed process leaves its folder behind, so the
// constructor also removes the folders of processes that no longer exist.
class TempFolder {
 public:
  // Makes the folder.  If that fails, throws std::runtime_error with the place and the system's
  // reason.
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  const int process_;
};

}  // namespace openr_host
