// A folder for a while, in the host's folder for such things.
#pragma once

#include <string>

namespace openr_host {

// Goes with its owner, in the process that made it.  Folders that a killed process left
// behind are removed when the next one is made.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  // Empty when it could not be made.
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  const int process_;
};

}  // namespace openr_host
