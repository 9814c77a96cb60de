// The private copy of a person's folder in which Makefiles run: what they leave behind stays out
// of the sources, and what does not suit the host can be changed.
//
// The copy keeps the times of files, and what was made in it, from one build to the next: only
// what changed is copied again, so make does what it would do in the folder itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "kit/source_copies.h"

namespace openr_host {

class WorkCopy {
 public:
  // `work`: a folder of the kit's own.  `sdk_root` replaces paths of other SDKs in Makefiles.
  WorkCopy(std::filesystem::path work, std::string sdk_root);

  // Brings the copy of `original`, an absolute folder, up to date, and of everything outside of it
  // that its Makefiles and sources name with "../" (referred_places.h).  Returns its place in the
  // copy.
  // Throws std::runtime_error when something cannot be read or written.
  std::filesystem::path Add(const std::filesystem::path& original);

  // Where `original` is, or would be, in the copy.
  std::filesystem::path PlaceOf(const std::filesystem::path& original) const;

  // Every folder added; the first one is what was asked for.  Folders around others, of which only
  // files were copied and no folders, come last.
  const std::vector<SourceCopy>& copies() const { return copies_; }

  // Object files, libraries and images for another processor, which are not copied; their
  // originals, each with the name of the processor.
  const std::map<std::string, std::string>& left_out() const { return left_out_; }

  // Whether the file of the copy came from the original as it is now, and not from the build.
  bool IsOriginal(const std::filesystem::path& file) const;

  // Remembers what was copied; to be called when all is added.
  void Save() const;

 private:
  struct Stamp {
    uintmax_t size = 0;
    int64_t time_ns = 0;
    bool operator==(const Stamp&) const = default;
  };

  void AddFolder(const std::filesystem::path& original);
  void CopyFile(const std::filesystem::path& original);
  void MakeStubsAnew() const;
  void RemoveVanished();
  bool IsCovered(const std::filesystem::path& original) const;
  static Stamp StampOf(const std::filesystem::path& file);

  const std::filesystem::path work_;
  const std::string sdk_root_;
  std::vector<SourceCopy> copies_;
  std::vector<std::filesystem::path> left_stubs_;  // copies of generated files, of this run
  std::map<std::string, std::string> left_out_, former_left_out_;
  std::map<std::string, Stamp> former_;   // by original: as of the last build
  std::map<std::string, Stamp> present_;  // by original: seen now
};

}  // namespace openr_host
