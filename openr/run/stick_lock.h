// Notices that two runs use the same stick.
#pragma once

#include <string>

namespace openr_host {

// While a StickLock exists, a StickLock for the same folder in another process sees it.  Two runs
// on one stick are allowed, but they write the same files: an upload to one run can break an upload
// to the other.
class StickLock {
 public:
  // Locks `folder`, the folder of a stick.  "" locks nothing.
  explicit StickLock(const std::string& folder);
  ~StickLock();
  StickLock(const StickLock&) = delete;
  StickLock& operator=(const StickLock&) = delete;

  // Returns a note for the user if another process has locked the folder before; else "".
  const std::string& note() const { return note_; }

 private:
  int descriptor_ = -1;
  std::string note_;
};

}  // namespace openr_host
