// Files and folders around a folder of programs that it uses: Makefiles, sources and headers name
// them by paths with "../".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace openr_host {

struct ReferredPlaces {
  // The folder itself, then folders outside of it, in the order in which they are found.  No folder
  // lies in another one.
  std::vector<std::filesystem::path> folders;
  // Folders around one of these, as VPATH=.. names them.  All that they hold is too much: their own
  // files count, without those of folders in them.
  std::vector<std::filesystem::path> around;
  std::vector<std::filesystem::path> files;  // of `around`
};

// The text of a Makefile with that of the files it includes, and with variables that stand for a
// path replaced by it: "$(TOP)/lib" is "../../lib" where TOP is "../..".
std::string ExpandedMakefile(const std::filesystem::path& file);

// Follows the paths from `root`, an absolute folder, and from what they lead to.
ReferredPlaces FindReferredPlaces(const std::filesystem::path& root);

}  // namespace openr_host
