// ImageObject: an object of the robot whose code is loaded from a file, the image.  On the host an
// image is a shared object, built from the object's sources and its stub (cmake/OpenrObject.cmake).
//
// Each object has static variables of its own, even if two objects are loaded from one file.  The
// loader would give two loads of one file the same static variables.  So every object is loaded
// from a copy of the image in the run folder.
#pragma once

#include <ObjectEntryTable.h>

#include <memory>
#include <string>
#include <vector>

#include "runtime/core/fp_flags.h"
#include "runtime/core/handler_stack.h"
#include "runtime/core/image_info.h"
#include "runtime/core/object.h"

namespace openr_host {

class RunFolder;

class ImageObject : public Object {
 public:
  ImageObject(System* the_system, ObjectId the_id, int the_robot)
      : Object(the_system, the_id, the_robot, true) {}
  ~ImageObject() override;  // unloads the image

  // Loads a copy of the image `file` and runs the constructors of its global objects as code of
  // this object.  Returns "", or the reason why the image cannot be loaded.
  std::string Load(const std::string& file, RunFolder* folder);

  bool HasCode(const void* address) const override;
  bool HasEntry(uint32_t selector) const override;
  bool Dispatch(uint32_t selector, void* payload) override;

  // Returns the bytes of stack that the image's own functions have used in the running handler, or
  // used in the last handler if none runs.  Returns 0 if the number is not known.
  size_t StackUsed() const { return stack_ == nullptr ? 0 : stack_->UsedBytes(); }

  // Adds a finding if the handler that has just ended did an operation that would stop the robot's
  // floating-point unit, or a division of the smallest integer by -1.  Called after every handler,
  // even after a handler that was abandoned.
  void CheckNumbers(uint32_t selector) {
    if ((FpFlags() & ~fp_seen_) != 0) ReportFpFlags(selector);
    if (number_faults().HasNewTooLargeQuotient()) ReportTooLargeQuotient(selector);
  }

 private:
  void MoveToOwnAddresses(std::string* bytes);
  std::string CheckVersions();
  std::string RedirectOwnImports();
  std::string RunConstructors();
  void Run(void (*function)(void*), void* argument);
  std::string ReadOcf();
  std::string ReadTables();
  void ReportFpFlags(uint32_t selector);
  void ReportTooLargeQuotient(uint32_t selector);

  std::unique_ptr<HandlerStack> stack_;  // null if addresses are not planned
  void* handle_ = nullptr;
  const ImageInfo* info_ = nullptr;  // points into the loaded image
  bool has_thunks_ = false;
  std::vector<Entry> entries_;  // entry functions by selector; null where the image has no entry
  // The flags (FpFlag) that handlers of this object have raised so far.  Each flag is reported
  // once.
  unsigned fp_seen_ = 0;
};

}  // namespace openr_host
