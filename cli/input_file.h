// Checks that files and folders named on a command line can be read.
#pragma once

#include <string>

namespace openr_host {

// Returns the reason why the file `path` cannot be read; "" if it can.  The reason is that of the
// system, such as "No such file or directory".  For a folder it is "is a folder; give a motion
// file", where "motion file" is `kind`; if a file in the folder ends in `extension` (".MTN", in any
// case), the text names it as an example.
std::string WhyNotReadable(const std::string& path, const std::string& kind,
                           const std::string& extension);

// Returns the reason why the folder `path` cannot be read; "" if it can.  For a file it is "is a
// file; give a folder of pictures", where "folder of pictures" is `kind`.
std::string WhyNoReadableFolder(const std::string& path, const std::string& kind);

// The kind of a file, as error messages call it, and the extension of its name.
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
