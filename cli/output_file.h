// Files and streams that a program writes: looked at before it begins its work, written so that a
// good file is never half replaced, and named with the system's reason when they cannot be.
//
// A name may be that of anything that can be written.  A regular file is replaced: the new content
// goes into a file beside it, which then takes its name; permissions and owner stay, and a symbolic
// link goes on leading to the file.  A file that has another name as well (a hard link), or whose
// folder does not let files be replaced, is written in place, if the disk has room for it.  Pipes
// and devices are written as they are.  /dev/stdout and /dev/fd/N mean the stream that the program
// was started with, behind what has been written to it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace openr_host {

// Why `file` cannot be written, or "".  Leaves everything as it was: a file that exists keeps
// its content, one that does not is not left behind.
std::string WhyNotWritable(const std::string& file);

// Whether `file` is a name of the standard output that the program was started with: /dev/stdout.
bool IsStandardOutput(const std::string& file);

// Why `folder` can be neither made nor written into, or "".  Leaves everything as it was.
std::string WhyNoFolder(const std::string& folder);

// "FILE: why", for people.
std::string Explain(const std::filesystem::filesystem_error& error);

// "FILE: cannot be written: why", where `error` is an errno.
std::string WhyNotWritten(const std::string& file, int error);

// Replaces the content of `file` by `bytes`, in whole or not at all.  Returns "" or what went
// wrong, with the file's name.
std::string WriteFile(const std::string& file, std::string_view bytes);

// A file whose new content lies beside it until all that belongs together has been written.
class PendingFile {
 public:
  explicit PendingFile(std::string file) : file_(std::move(file)) {}
  ~PendingFile();  // without Commit() nothing has happened
  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;

  // Both return "" or what went wrong, with the file's name.
  std::string Write(std::string_view bytes);
  std::string Commit();

 private:
  const std::string file_;
  std::string bytes_;
  std::string target_;     // the file without links at its end
  std::string temporary_;  // beside it; "": there is none, Commit() writes in place
};

// Replaces `to` by a copy of the file `from`, with its permissions; returns as WriteFile().
std::string CopyToFile(const std::string& from, const std::string& to);

// Removes `file` if it is a regular file; a device stays.
void RemoveFile(const std::string& file);

// Opens a file that grows while the program works, empty at first.  A regular file stays locked
// until the descriptor is closed or the process ends, however it ends; one that another process
// writes in this way is refused, with its process id.  Returns -1 and sets `problem` on failure.
int OpenGrowingFile(const std::string& file, std::string* problem);

// Writes all of `text` to `descriptor`.  Returns 0 or the errno that kept the rest from being
// written.  Fit for signal handlers.
int WriteAll(int descriptor, std::string_view text);

// How a file will be replaced, worked out in advance for a signal handler, which may not allocate.
class PreparedFile {
 public:
  explicit PreparedFile(const std::string& file);

  // The descriptor to write to; -1 on failure.
  int Open();
  // The file has its new content.
  void Close();

 private:
  static constexpr size_t kPathBytes = 4096;
  char target_[kPathBytes] = "";     // "": there is no such file
  char temporary_[kPathBytes] = "";  // "": written in place
  int stream_ = -1;                  // meant instead of a file
  int descriptor_ = -1;
  unsigned mode_ = 0666;
  bool keeps_mode_ = false;  // that of the file which is replaced
};

}  // namespace openr_host
