// The Memory Stick of a bench: a temporary folder that goes with it, so that a test can
// neither spoil a stick nor disturb another test.
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
  // A copy of the folder `model`, which holds OPEN-R/, or an empty stick when it is "".
  // Throws std::runtime_error when there is no such folder or no room.
  explicit BenchStick(const std::string& model);

  // ---- for tests; names as objects use them: "/MS/OPEN-R/MW/DATA/P/TABLE.TXT"

  // Makes or replaces a file and the folders above it.  Throws std::runtime_error when the
  // name is not one of the stick.
  void Write(const std::string& name, std::string_view bytes);
  // The whole file; nullopt when there is none.
  std::optional<std::string> Read(const std::string& name) { return ReadFile(name); }
  bool Has(const std::string& name) { return Locate(name).exists; }
  // Full names of all files below `folder`, sorted.
  std::vector<std::string> List(const std::string& folder = "/MS");
  void Remove(const std::string& name);

  // A copy of an image of the host, with its debug information if that lies beside it.  Throws
  // std::runtime_error when there is no such file.
  void ImportImage(const std::string& host_file, const std::string& name);

  // Goes on with a copy of its own, in a copy of the process (fork).
  void MoveToCopy();

  // ---- MemoryStick
  Location Locate(std::string_view name) override { return files_->Locate(name); }
  uint64_t ContentHash() override { return files_->ContentHash(); }

 private:
  std::unique_ptr<openr_host::TempFolder> folder_;
  std::unique_ptr<openr_host::FolderStick> files_;
};

}  // namespace openr::testing
