// Received data on pages of their own: read-only, and no longer there once they are given back.
//
// On the robot with memory protection a region is read-only for its observer, and its data
// are those of somebody else after AssertReady() (field-notes.md, 2.11 and 3.1).  Zero-copy
// regions hide both mistakes; here they are a fault at the instruction that makes them.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

namespace openr_host {

class GuardPages {
 public:
  GuardPages() = default;
  ~GuardPages();
  GuardPages(const GuardPages&) = delete;
  GuardPages& operator=(const GuardPages&) = delete;

  // A read-only copy of `size` bytes.  Null when there is no memory.
  char* NewCopy(const char* data, size_t size);

  // Whoever touches the copy from now on faults.  Addresses are never used twice.  What is
  // no copy of here is left alone.
  void Retire(const char* copy);

 private:
  // Address space taken at a time; memory only where copies are alive.
  static constexpr size_t kBlockBytes = size_t{1} << 28;

  std::map<const char*, size_t> copies_;  // alive, with their sizes; looked up only
  std::vector<char*> blocks_;
  size_t used_ = kBlockBytes;  // of the last block
};

}  // namespace openr_host
