// Writes the files and streams of a program.  A name is checked before the work begins, a good file
// is never left half replaced, and error messages give the reason of the system.
//
// A regular file is replaced: the new content is written to a temporary file in the same folder,
// and this file is then renamed to the name of the old file.  Permissions and owner stay, and a
// symbolic link still leads to the file.  Two kinds of files are written in place instead, if the
// disk has room: a file with a second name (a hard link), and a file in a folder where files cannot
// be replaced.  Pipes and devices are written directly.  /dev/stdout and /dev/fd/N mean the stream
// that the program was started with; the new text follows the text that the stream has got before.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace openr_host {

// Returns the reason why `file` cannot be written; "" if it can.  Changes nothing: an existing file
// keeps its content, and a missing file is not created.
std::string FileWriteProblem(const std::string& file);

// Returns whether `file` is a name of the standard output that the program was started with, such
// as /dev/stdout.
bool IsStandardOutput(const std::string& file);

// Returns the reason why the program can neither create `folder` nor write files in it; "" if it
// can.  Changes nothing.
std::string FolderWriteProblem(const std::string& folder);

// Returns the error of a file system call as "FILE: why", for people to read.
std::string Explain(const std::filesystem::filesystem_error& error);

// Returns "FILE: cannot be written: why", where `error` is an errno.
std::string WriteErrorText(const std::string& file, int error);

// Replaces the whole content of `file` by `bytes`, or changes nothing.  Returns "" or the error,
// with the name of the file.
std::string WriteFile(const std::string& file, std::string_view bytes);

// A file that is replaced in two steps: Write() puts the new content in a file beside it, and
// Commit() puts this file in its place.  So several files can be changed together, if Commit() is
// called only after Write() has succeeded for all.
class PendingFile {
 public:
  explicit PendingFile(std::string file) : file_(std::move(file)) {}
  ~PendingFile();  // without Commit(), the file keeps its content
  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;

  // Write() and Commit() return "" or the error message, with the name of the file.
  std::string Write(std::string_view bytes);
  std::string Commit();

 private:
  const std::string file_;
  std::string bytes_;
  std::string target_;  // path of the file, after symbolic links were followed
  // Path of the temporary file with the new content.  If it is "", there is no temporary file, and
  // Commit() writes the content in place.
  std::string temporary_;
};

// Replaces `to` by a copy of the file `from`, with the permissions of `from`.  A device, a pipe or
// an open stream gets only the content, and keeps its permissions.  Returns "" or the error
// message, as WriteFile() does.
std::string CopyToFile(const std::string& from, const std::string& to);

// Removes `file` if it is a regular file; does nothing to a device.
void RemoveFile(const std::string& file);

// Writes all of `text` to `descriptor`.  Returns 0, or the errno of the write that failed.  May be
// called in a signal handler.
int WriteAll(int descriptor, std::string_view text);

}  // namespace openr_host
