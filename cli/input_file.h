// Files a command is to read.
#pragma once

#include <string>

namespace openr_host {

// The reason why the file `path` cannot be read, or "": "No such file or directory" as the system
// gives it, or "is a folder; give a motion file" (the `kind`), with a file in the folder that ends
// in `extension` (".MTN", in any case) as an example if there is one.
std::string WhyNotReadable(const std::string& path, const std::string& kind,
                           const std::string& extension);

// The same for a folder: "is a file; give a folder of pictures" (the `kind`) when it is none.
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
