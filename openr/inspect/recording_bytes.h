// Reads the bytes of a recording.  Keeps only the wanted part in memory, because the recording of a
// day has some GiB.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace openr_host {

class RecordingBytes {
 public:
  // Opens the file `file`.  Throws std::runtime_error if it cannot be opened.  A pipe or a device
  // cannot be read at an offset, so all its bytes are read here at once.
  explicit RecordingBytes(const std::string& file);
  ~RecordingBytes();
  RecordingBytes(const RecordingBytes&) = delete;
  RecordingBytes& operator=(const RecordingBytes&) = delete;

  // Returns how many bytes the file had when it was opened.  A recording that is being written gets
  // longer; the bytes that come later are left out.
  uint64_t size() const { return size_; }

  // Returns the `count` bytes from the offset `at` on, which are valid until the next call.
  // Returns fewer bytes if the file ends earlier, or if reading fails; error() then says why.
  std::string_view Read(uint64_t at, uint64_t count);
  // Returns the errno of the last Read() that failed; 0: none has failed.
  int error() const { return error_; }

 private:
  uint64_t size_ = 0;
  int descriptor_ = -1;  // the open file; -1: all bytes are in part_
  std::string part_;     // bytes of the file, to which Read() returns a view
  int error_ = 0;
};

}  // namespace openr_host
