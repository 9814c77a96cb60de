// MemoryMap: the ranges of memory that this process has.
#pragma once

#include <cstdint>
#include <cstdio>

namespace openr_host {

struct MappedRange {
  uintptr_t begin = 0;
  uintptr_t end = 0;  // the address behind the last byte
  // Whether the range may be read and written, has no code and is shared with no other process.
  bool is_private_data = false;
  bool is_main_stack = false;  // whether the range is the stack of the first thread
};

// Reads the kernel's list of the ranges of memory of this process (/proc/self/maps, see proc(5)),
// in the order of their addresses.
//
// Reads line by line and not with ReadFile(), because the text that ReadFile() returns would change
// the ranges while it grows.
class MemoryMap {
 public:
  MemoryMap();  // if the kernel's list cannot be opened, the MemoryMap is empty
  ~MemoryMap();
  MemoryMap(const MemoryMap&) = delete;
  MemoryMap& operator=(const MemoryMap&) = delete;

  // Sets `*range` to the next range of memory of this process.  Returns false after the last range.
  bool Next(MappedRange* range);

 private:
  std::FILE* const list_;  // null: the list could not be opened
};

}  // namespace openr_host
