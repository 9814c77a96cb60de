// A temporary folder in the host's folder for temporary files.
#pragma once

#include <string>

namespace openr_host {

// The destructor removes the folder, but only in the process that made it, not in its forks.
// Because a killed process leaves its folder behind, the constructor removes such folders.
class TempFolder {
 public:
  // Throws std::runtime_error with the place and the system's reason if no folder can be made.
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
