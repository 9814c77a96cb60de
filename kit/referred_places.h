// Finds the files and folders that a program uses outside of its own folder.  Makefiles, sources
// and headers name them by paths with "../".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace openr_host {

struct ReferredPlaces {
  // The folder of the program, then folders outside of it in the order in which they were found.
  // No folder of this list is inside another folder of the list.
  std::vector<std::filesystem::path> folders;
  // Folders that contain one of `folders` and that a Makefile names, such as the parent folder in
  // "VPATH=..".  Only the files directly in them count, because files in folders below them may not
  // belong to the program.
  std::vector<std::filesystem::path> around;
  std::vector<std::filesystem::path> files;  // the files directly in the folders of `around`
};

// Returns the text of a Makefile and of the files that it includes.  Variables that stand for paths
// are replaced by their values: "$(TOP)/lib" becomes "../../lib" if TOP is "../..".
std::string ExpandedMakefile(const std::filesystem::path& file);

// Searches the files below `root`, an absolute folder, for paths that lead out of `root`.  Then
// searches the files to which these paths lead in the same way.  Returns all files and folders
// outside of `root` that were found.
ReferredPlaces FindReferredPlaces(const std::filesystem::path& root);

}  // namespace openr_host
