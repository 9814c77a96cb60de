// RunFolder: a temporary folder for copies of images (files with the code of an object).
#pragma once

#include <string>

#include "runtime/base/temp_folder.h"

namespace openr_host {

// The destructor removes the folder.
//
// A copy of an image is changed for its load address, and is then loaded.  From the changed file, a
// debugger would compute wrong addresses of symbols, so after loading the original file takes the
// place of the copy.
class RunFolder {
 public:
  // Makes a folder for a copy of the image `file`, and returns the path that the copy will have.
  // Keeps `bytes`, the content of the image, for RestoreOriginal().  If a file with debug
  // information (NAME.DBG) lies beside `file`, makes a link to it in the new folder, where
  // debuggers look for it.  If the folder cannot be written, returns "" and sets `*problem` to the
  // reason.
  std::string AddCopy(const std::string& file, const std::string& bytes, std::string* problem);

  // Writes `bytes`, the changed content of the image, to the file `copy`, a path that AddCopy() has
  // returned.  Returns "" or the reason why the file cannot be written.
  std::string WriteCopy(const std::string& copy, const std::string& bytes);

  // Replaces the file `copy`, after it was loaded, by the original.  The loaded memory does not
  // change.  If the file cannot be replaced, debuggers show wrong addresses; the run is not
  // affected.
  void RestoreOriginal(const std::string& copy);

 private:
  // Keeps `bytes`, the original of the image `copy`, in a file.  The robots of a run mostly have
  // the same images, so files with the same bytes are hard links: each original needs memory only
  // once.  Returns whether the file was made.
  bool AddOriginal(const std::string& copy, const std::string& bytes);

  const TempFolder folder_{TempUse::kSmallFiles};
};

}  // namespace openr_host
