// BenchStick, the Memory Stick of a bench: a temporary folder.  The folder is removed together with
// the bench, so a test can neither spoil a stick nor disturb another test.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/temp_folder.h"
#include "runtime/stick/memory_stick.h"

namespace openr::testing {

class BenchStick : public openr_host::MemoryStick {
 public:
  // Copies the folder `model`, which must contain the folder OPEN-R; "" makes an empty stick.
  // Throws std::runtime_error when OPEN-R is missing or the disk has no room for the copy.
  explicit BenchStick(const std::string& model);

  // ---- Functions for tests.  File names are as on the robot: "/MS/OPEN-R/MW/DATA/P/TABLE.TXT"

  // Creates or replaces a file, and creates the folders above it.  Throws std::runtime_error when
  // the name is not below /MS.
  void Write(const std::string& name, std::string_view bytes);
  // Returns the content of the file `name`; nullopt when there is no such file.
  std::optional<std::string> Read(const std::string& name) { return ReadFile(name); }
  bool Has(const std::string& name) { return Locate(name).exists; }
  // Returns the full names of all files below `folder`, sorted.
  std::vector<std::string> List(const std::string& folder = "/MS");
  void Remove(const std::string& name);

  // Copies the image `host_file` to `name` on the stick.  If the image has a file with debug
  // information (.DBG), makes a symbolic link to that file beside the copy, where the loader of
  // images looks for it.  Throws std::runtime_error when the image cannot be read.
  void ImportImage(const std::string& host_file, const std::string& name);

  // Copies the files to a new folder, and uses only the new folder from now on.  Called in a copy
  // of the process (fork), so that the copy cannot change the files of the original process.
  void MoveToCopy();

  // ---- Implementation of MemoryStick
  Location Locate(std::string_view name) override { return files_->Locate(name); }
  uint64_t ContentHash() override { return files_->ContentHash(); }

 private:
  std::unique_ptr<openr_host::TempFolder> folder_;
  std::unique_ptr<openr_host::FolderStick> files_;
};

}  // namespace openr::testing
