// Makes a Memory Stick tree completely or, if anything fails, not at all.
#pragma once

#include <filesystem>
#include <string>

namespace openr_host {

// A temporary folder beside the output, in which the stick is made.  Finish() renames the finished
// stick to the output.  The destructor removes the temporary folder, so that a failure leaves
// nothing.
class StickDraft {
 public:
  // Throws std::runtime_error if `output` exists already, or if no folder can be made beside it.
  explicit StickDraft(const std::string& output);
  ~StickDraft();
  StickDraft(const StickDraft&) = delete;
  StickDraft& operator=(const StickDraft&) = delete;

  std::filesystem::path stick() const { return folder_ / "stick"; }
  std::filesystem::path work() const { return folder_ / "work"; }
  void Finish();

 private:
  const std::filesystem::path output_;
  std::filesystem::path folder_;
};

// Copies a tree of files and makes the copy writable, because files of the SDK may be read-only.
void CopyTree(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace openr_host
