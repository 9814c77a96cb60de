// Finds out what the name of an output file means, and makes the file that replaces it.  Used by
// the code in cli/ that writes files; output_file.h has the rules.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <string>

namespace openr_host {

constexpr int kTemporaryNamesMax = 100;  // number of tries to find a name that no other file has

// The target that the name of an output file means: an open stream of this process, as for the name
// /dev/stdout, or a file.
struct OutputTarget {
  int stream = -1;   // descriptor of an open stream of this process; -1: the target is a file
  std::string path;  // path of the target file, after symbolic links were followed
  bool exists = false;
  struct stat status {};  // status of the target file; set only if `exists`
};

// Returns the open stream or the file that the name `file` means.  Follows symbolic links.
OutputTarget OutputTargetOf(const std::string& file);

// Returns whether a new file with the new content replaces `target`.  If not, the content is
// written into `target` itself (in place).  Returns false for devices and pipes.  Returns false
// also for a file with several hard links, because its other names would keep the old content.
bool IsReplaced(const OutputTarget& target);

// Returns the path of the temporary file with the number `number` beside the file `beside`.
std::string TemporaryName(const std::filesystem::path& beside, int number);

// Returns whether a file may be written in place after replacing it has failed with `error`.
// Returns true if the system refuses to make a new file, but false if the disk is full.
bool MayBeInPlace(int error);

// Makes an empty file beside `target`, with the owner and permissions of `target`, and sets `name`
// to its path.  Returns the descriptor.  After an error returns -1, sets `error` to the errno, and
// leaves no file behind.
int CreateBeside(const OutputTarget& target, std::string* name, int* error);

}  // namespace openr_host
