// Images: objects loaded from files, each instance with statics of its own.
//
// On the host such a file is a shared object built from the object's sources and
// its stub (cmake/OpenrObject.cmake).  Every instance is loaded from a copy in the
// run folder, because the loader would give two loads of one file the same statics.
#pragma once

#include <ObjectEntryTable.h>

#include <memory>
#include <string>
#include <vector>

#include "runtime/base/temp_folder.h"
#include "runtime/core/fp_flags.h"
#include "runtime/core/handler_stack.h"
#include "runtime/core/object.h"

namespace openr_host {

// What a host image says of itself, besides ObjectEntryTable.  Generated into every
// image by the build; its name there is openr_image_info.
struct ImageInfo {
  uint32_t version;  // kImageVersion
  uint32_t reserved;
  const char* ocf;  // text of the .ocf file
};
constexpr uint32_t kImageVersion = 1;

// A folder for copies of images that goes with its owner.
class RunFolder {
 public:
  // Writes `bytes`, which are those of `file`, under a new name; the debug file beside
  // `file` (NAME.DBG) is linked.  Empty, and `*problem` says why, when they cannot be written.
  std::string AddCopy(const std::string& file, const std::string& bytes, std::string* problem);

  // Puts `bytes` in place of a copy that has been loaded, without touching what was mapped: for
  // those who look symbols up in the file of that name.  If that fails, they find wrong ones.
  void Replace(const std::string& copy, const std::string& bytes);

 private:
  const TempFolder folder_;
};

class ImageObject : public Object {
 public:
  using Object::Object;
  ~ImageObject() override;  // unloads

  // Loads a copy of `file`; constructors of its globals run as code of this object, on the stack
  // of its handlers.
  // Returns what is wrong, or "".
  std::string Load(const std::string& file, RunFolder* folder);

  bool HasCode(const void* address) const override;
  bool HasEntry(uint32_t selector) const override;
  bool Dispatch(uint32_t selector, void* payload) override;

  // How many bytes of stack its own functions used in the handler that runs or that ran last; 0
  // where it is not known.
  size_t StackUsed() const { return stack_ == nullptr ? 0 : stack_->UsedBytes(); }

  // After its handler has ended, in whatever way: what it did that the robot's floating-point unit
  // does not forgive becomes a finding.
  void CheckNumbers(uint32_t selector) {
    if ((FpFlags() & ~fp_seen_) != 0) ReportFpFlags(selector);
  }

 private:
  std::string TakePlace(const std::string& original);
  std::string TakeImports();
  std::string RunConstructors();
  void Run(void (*function)(void*), void* argument);
  std::string ReadTables();
  void ReportFpFlags(uint32_t selector);

  std::unique_ptr<HandlerStack> stack_;  // null where addresses are not planned
  void* handle_ = nullptr;
  bool has_thunks_ = false;
  std::vector<Entry> entries_;  // by selector; null: none
  unsigned fp_seen_ = 0;        // FpFlags() of its handlers so far
};

}  // namespace openr_host
