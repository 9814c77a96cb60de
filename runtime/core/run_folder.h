// RunFolder: a temporary folder for copies of images (files with the code of an object).
#pragma once

#include <string>

#include "runtime/base/temp_folder.h"

namespace openr_host {

// The destructor removes the folder.
class RunFolder {
 public:
  // Writes `bytes`, the content of the image `file`, to a new file and returns the new file's path.
  // If a file with debug information (NAME.DBG) lies beside `file`, makes a link to it beside the
  // copy, where debuggers look for it.  If the copy cannot be written, returns "" and sets
  // `*problem` to the reason.
  std::string AddCopy(const std::string& file, const std::string& bytes, std::string* problem);

  // Replaces the file `copy`, after it was loaded, by a new file with `bytes`, the bytes of the
  // original image.  The copy was changed for its load address, so debuggers would compute wrong
  // addresses of symbols from the copy.  The loaded memory does not change.  If the new file cannot
  // be written, debuggers show wrong addresses; the run is not affected.
  void Replace(const std::string& copy, const std::string& bytes);

 private:
  const TempFolder folder_{TempUse::kSmallFiles};
};

}  // namespace openr_host
