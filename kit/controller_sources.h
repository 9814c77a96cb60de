// Which sources a controller has.
#pragma once

#include <filesystem>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

struct ControllerSources {
  std::vector<std::filesystem::path> files;  // in the order named, else of names
  std::filesystem::path list;                // Makefile.sources; empty: there is none
  std::vector<Diagnostic> diagnostics;       // of the list: files that are not there, and more
};

// What Makefile.sources of `folder` names, whatever its variables are called: every word of their
// values, as make expands them, that ends like a source.  Without that file, the *.c, *.cc and
// *.cpp of the folder itself.
ControllerSources FindControllerSources(const std::filesystem::path& folder);

// Whether `folder` is that of a controller: it has a Makefile.sources, or a source that includes
// robot.h.
bool IsControllerFolder(const std::filesystem::path& folder);

}  // namespace openr_host
