// A folder for a while, in the host's folder for such things.
#pragma once

#include <string>

namespace openr_host {

// Goes with its owner, in the process that made it.  Folders that a killed process left
// behind are removed when the next one is made.
class TempFolder {
 public:
  // Throws std::runtime_error, with the place and the system's reason, when it cannot be made.
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
