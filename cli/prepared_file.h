// PreparedFile: a file that a signal handler will write in place of the old file of this name.
#pragma once

#include <cstddef>
#include <string>

namespace openr_host {

// A file that a signal handler will write by Open() and Close().  The rules in output_file.h hold
// for this file, too: a regular file is replaced, other files are written in place.  The
// constructor finds out the paths of the file and of the temporary file beside it, because a signal
// handler may not allocate memory.
class PreparedFile {
 public:
  explicit PreparedFile(const std::string& file);

  // Opens the file or stream to which the new content is written: a temporary file beside the old
  // file, the old file itself, or the open stream that the file name means.  Returns the
  // descriptor, or -1 on failure.
  int Open();
  // Closes the descriptor that Open() has returned, and replaces the file by the content that was
  // written to it.
  void Close();

 private:
  static constexpr size_t kPathBytes = 4096;
  char target_[kPathBytes] = "";  // path of the file to replace; "" if there is none
  // Path of the temporary file with the new content; "": none is used.
  char temporary_[kPathBytes] = "";
  // The open stream that the file name means; -1: the name means a file.
  int stream_ = -1;
  int descriptor_ = -1;
  unsigned mode_ = 0666;
  bool keeps_mode_ = false;  // true: the new file gets mode_, which is the mode of the old file
};

}  // namespace openr_host
