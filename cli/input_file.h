// Checks that files and folders named on a command line can be read.
#pragma once

#include <string>

namespace openr_host {

// Returns the reason why the file `path` cannot be read; "" if it can be read.  The reason is a
// text of the system, such as "No such file or directory".  If `path` is a folder, the reason is
// "is a folder; give a motion file", where the words "motion file" are `kind`.  If a file in the
// folder ends in `extension` (".MTN", in upper or lower case), the text names this file as an
// example.
std::string FileReadProblem(const std::string& path, const std::string& kind,
                            const std::string& extension);

// Returns the reason why the folder `path` cannot be read; "" if it can be read.  If `path` is a
// file, the reason is "is a file; give a folder of pictures", where the words "folder of pictures"
// are `kind`.
std::string FolderReadProblem(const std::string& path, const std::string& kind);

// A kind of file: its name in error messages, and the extension of such files.
struct InputKind {
  const char* kind;
  const char* extension;
};
// The words for a stick in the messages of FolderReadProblem().
constexpr char kStickKind[] = "folder that holds OPEN-R";
constexpr InputKind kWorldFile = {"world file (docs/worlds.md)", ".json"};
constexpr InputKind kCostFile = {"cost file (docs/exploring.md)", ".cost"};
constexpr InputKind kRecordingFile = {"recording of openr run --record", ".rec"};

// Throws std::runtime_error "FILE: reason" when the file cannot be read.
void RequireReadable(const std::string& path, const InputKind& kind);

}  // namespace openr_host
