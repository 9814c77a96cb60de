// Checks that files and folders named on a command line can be read.
#pragma once

#include <string>

namespace openr_host {

// Returns the reason why the file `path` cannot be read, or "".  The reason is the system's, such
// as "No such file or directory", or "is a folder; give a motion file" with the `kind` of file.  If
// the folder has a file that ends in `extension` (".MTN", in any case), the text names that file as
// an example.
std::string WhyNotReadable(const std::string& path, const std::string& kind,
                           const std::string& extension);

// Returns the same for a folder: "is a file; give a folder of pictures" (the `kind`) when `path` is
// no folder.
std::string WhyNoReadableFolder(const std::string& path, const std::string& kind);

// The kinds and extensions of files that several commands read.
struct InputKind {
  const char* kind;
  const char* extension;
};
constexpr InputKind kWorldFile = {"world file (docs/worlds.md)", ".json"};
constexpr InputKind kCostFile = {"cost file (docs/exploring.md)", ".cost"};
constexpr InputKind kRecordingFile = {"recording of openr run --record", ".rec"};

// Throws std::runtime_error "FILE: reason" when the file cannot be read.
void RequireReadable(const std::string& path, const InputKind& kind);

}  // namespace openr_host
