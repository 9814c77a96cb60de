// Makes a Memory Stick tree completely or, if anything fails, not at all.
#pragma once

#include <filesystem>
#include <string>

namespace openr_host {

// A temporary folder in which a stick is made.  It lies beside `output`, the path of the finished
// stick.  Finish() renames the stick to `output`.  The destructor removes the temporary folder, so
// that a failure leaves nothing.
class StickDraft {
 public:
  // Makes the temporary folder.  Throws std::runtime_error if `output` exists already, or if the
  // temporary folder cannot be made in the folder that is to contain `output`.
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
