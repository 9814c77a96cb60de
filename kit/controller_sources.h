// Finds the sources of a controller.
#pragma once

#include <filesystem>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

struct ControllerSources {
  // The sources of the controller, in the order in which Makefile.sources (`list`) names them, or
  // in the order of their names if there is no Makefile.sources.
  std::vector<std::filesystem::path> files;
  std::filesystem::path list;           // path of Makefile.sources; empty: there is no such file
  std::vector<Diagnostic> diagnostics;  // mistakes in Makefile.sources, such as a missing file
};

// Returns the sources that Makefile.sources of `folder` names.  The variables of this file may have
// any names: after make has expanded their values, every word that ends in .c, .cc or .cpp is a
// source.  If there is no Makefile.sources, returns the *.c, *.cc and *.cpp files of the folder
// itself.
ControllerSources FindControllerSources(const std::filesystem::path& folder);

// Returns whether `folder` is the folder of a controller: it has a Makefile.sources, or a source
// that includes robot.h.
bool IsControllerFolder(const std::filesystem::path& folder);

}  // namespace openr_host
