// Files that a run keeps open and writes to again and again, such as a log of data.  A name such
// as /dev/stdout means an open stream instead of a file (output_file.h).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace openr_host {

// Opens a file that the program goes on writing during its work, such as a recording, and empties
// it.  A regular file stays locked until the descriptor is closed or the process ends.  Refuses a
// file that another process has locked in this way, and names that process.  On failure returns -1
// and sets `problem`.
int OpenGrowingFile(const std::string& file, std::string* problem);

// Opens a file as OpenGrowingFile() does, but puts a new file in the place of a regular file, as
// WriteFile() does.  So a program that reads the old file meanwhile goes on reading the old
// content.
int OpenNewGrowingFile(const std::string& file, std::string* problem);

// A file that a run keeps open and writes to again and again.  After each call of Append() the
// content of the file is complete, so that other programs can read it.
class GrowingFile {
 public:
  // Creates `file`, or empties it.  Throws std::runtime_error when it cannot be created, or when
  // another process is writing to it.
  explicit GrowingFile(const std::string& file);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  // Appends `bytes`.  If that fails, removes the part of `bytes` that was written and writes
  // nothing more, so that the file ends with the bytes of the last complete call.
  //
  // `end` is text that completes the file, for example "]" after a list.  Each call overwrites the
  // `end` of the call before.  So the file is complete even if the process is killed between two
  // calls, or if a later call fails.  A pipe or a terminal gets no `end`, because text that was
  // written to them cannot be replaced.
  void Append(std::string_view bytes, std::string_view end = "");

  // Returns "FILE: cannot be written: why" if a write has failed, else "".
  std::string Problem() const;

 private:
  const std::string file_;
  int descriptor_ = -1;
  bool can_go_back_ = false;
  size_t size_ = 0;  // number of bytes of the file before end_
  std::string end_;  // text at the end of the file that completes the file, such as "]"
  int error_ = 0;    // errno of the first failed write
};

}  // namespace openr_host
