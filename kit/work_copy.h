// A private copy of the user's folder, in which Makefiles run.  The files that the Makefiles make
// stay out of the user's folder, and files that do not fit the host can be changed in the copy.
//
// The copy stays from one build to the next, with the times of files and with the files that builds
// have made in it.  Only changed files are copied again, so make rebuilds the same files that it
// would rebuild in the user's folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "kit/build_variant.h"
#include "kit/source_copies.h"

namespace openr_host {

// Returns the folder in the user's cache for private copies of `folder`, an absolute path.  Each
// variant, such as "debug", has a folder of its own.
std::filesystem::path DefaultWorkFolder(const std::filesystem::path& folder, BuildVariant variant);

class WorkCopy {
 public:
  // Opens or creates the private copy of the user's folder in the folder `work`.  In copied
  // Makefiles, `sdk_root`, the SDK tree of this project, replaces the paths of other SDKs.
  WorkCopy(std::filesystem::path work, std::string sdk_root);

  // Brings the copy of `original`, an absolute folder, up to date.  Also copies the files and
  // folders outside of `original` that its Makefiles and sources name with "../"
  // (referred_places.h).  Returns the path of the copy.  Throws std::runtime_error when something
  // cannot be read or written.
  std::filesystem::path Add(const std::filesystem::path& original);

  // Returns the path that the copy of `original` has or would have, even if `original` was not
  // copied.
  std::filesystem::path PlaceOf(const std::filesystem::path& original) const;

  // Returns all copied folders.  The first is the folder that the user named.  The last are the
  // folders of ReferredPlaces::around: only the files directly in these folders were copied.
  const std::vector<SourceCopy>& copies() const { return copies_; }

  // Returns the originals of object files, libraries and images that were not copied because they
  // are for another processor, each with the name of the processor.
  const std::map<std::string, std::string>& left_out() const { return left_out_; }

  // Returns whether `file`, a file of the copy, is an unchanged copy of the user's file and was not
  // made by the build.
  bool IsOriginal(const std::filesystem::path& file) const;

  // Writes the names, sizes and times of the copied files to the work folder, so that the next
  // build finds out which files have changed.  Add() calls Save() at its end.
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
  void RemoveObjectFiles() const;
  bool IsCovered(const std::filesystem::path& original) const;
  static Stamp StampOf(const std::filesystem::path& file);

  const std::filesystem::path work_;
  const std::string sdk_root_;
  std::vector<SourceCopy> copies_;
  // Copied files that stubgen2 had made in the user's folder; MakeStubsAnew() replaces them.
  std::vector<std::filesystem::path> left_stubs_;
  std::map<std::string, std::string> left_out_, former_left_out_;
  // True: a header or a stub.cfg is new, was removed or has changed since the last build.
  bool has_new_headers_ = false;
  // Size and time of the user's files at the last build; the key is the path.  A file with the same
  // size and time is not copied again.
  std::map<std::string, Stamp> former_;
  // Size and time of the user's files at this build; the key is the path.  The next build compares
  // them to find out which files have changed.
  std::map<std::string, Stamp> present_;
};

}  // namespace openr_host
