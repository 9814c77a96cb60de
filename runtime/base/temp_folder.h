// TempFolder: a folder for files that only this process needs, in the host's folder for temporary
// files.
#pragma once

#include <string>

namespace openr_host {

// The destructor removes the folder, but only in the process that made it, not in the forks of that
// process.  A killed process leaves its folder behind, so the constructor removes the folders of
// killed processes.
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
