// Writes the files and streams of a program.  Names are checked before the work begins, a good file
// is never left half replaced, and errors give the reason of the system.
//
// A regular file is replaced: the new content goes into a temporary file beside it, which then
// takes its name.  Permissions and owner stay, and a symbolic link still leads to the file.  A file
// that has a second name (a hard link), or that lies in a folder where files cannot be replaced, is
// written in place, if the disk has room.  Pipes and devices are written directly. /dev/stdout and
// /dev/fd/N mean the stream that the program was started with; the text follows what was written
// there before.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace openr_host {

// Returns the reason why `file` cannot be written, or "".  Changes nothing: an existing file keeps
// its content, and a missing file is not created.
std::string WhyNotWritable(const std::string& file);

// Returns whether `file` is a name of the standard output that the program was started with, such
// as /dev/stdout.
bool IsStandardOutput(const std::string& file);

// Returns the reason why `folder` can be neither created nor written to, or "".  Changes nothing.
std::string WhyNoFolder(const std::string& folder);

// Returns "FILE: why", for people to read.
std::string Explain(const std::filesystem::filesystem_error& error);

// Returns "FILE: cannot be written: why", where `error` is an errno.
std::string WhyNotWritten(const std::string& file, int error);

// Replaces the whole content of `file` by `bytes`, or changes nothing.  Returns "" or the error,
// with the name of the file.
std::string WriteFile(const std::string& file, std::string_view bytes);

// A file that is replaced in two steps, so that several files can change together: Write() puts the
// new content beside the file, Commit() puts it in place.
class PendingFile {
 public:
  explicit PendingFile(std::string file) : file_(std::move(file)) {}
  ~PendingFile();  // without Commit() the file stays as it was
  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;

  // Both return "" or the error, with the name of the file.
  std::string Write(std::string_view bytes);
  std::string Commit();

 private:
  const std::string file_;
  std::string bytes_;
  std::string target_;     // path of the file without links at its end
  std::string temporary_;  // file with the new content; "": none, Commit() writes in place
};

// Replaces `to` by a copy of the file `from`, with its permissions.  Returns "" or the error, as
// WriteFile() does.
std::string CopyToFile(const std::string& from, const std::string& to);

// Removes `file` if it is a regular file; does nothing to a device.
void RemoveFile(const std::string& file);

// Opens a file that grows while the program works, and empties it.  A regular file stays locked
// until the descriptor is closed or the process ends.  Refuses a file that another process has
// locked in this way, and names that process.  Returns -1 and sets `problem` on failure.
int OpenGrowingFile(const std::string& file, std::string* problem);

// Writes all of `text` to `descriptor`.  Returns 0, or the errno of the write that failed.  May be
// called in a signal handler.
int WriteAll(int descriptor, std::string_view text);

// A file to be replaced by a signal handler.  All names are worked out in the constructor, because
// the handler may not allocate.
class PreparedFile {
 public:
  explicit PreparedFile(const std::string& file);

  // Returns the descriptor to write to; -1 on failure.
  int Open();
  // Gives the file its new content: what has been written to the descriptor.
  void Close();

 private:
  static constexpr size_t kPathBytes = 4096;
  char target_[kPathBytes] = "";     // path of the file; "": none
  char temporary_[kPathBytes] = "";  // path of the temporary file; "": write in place
  int stream_ = -1;                  // stream to write to instead of a file; -1: none
  int descriptor_ = -1;
  unsigned mode_ = 0666;
  bool keeps_mode_ = false;  // the new file gets the mode of the old one
};

}  // namespace openr_host
