// Which sources a controller has.
#pragma once

#include <filesystem>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

struct ControllerSources {
  std::vector<std::filesystem::path> files;  // in the order named, else of names
  std::filesystem::path list;                // Makefile.sources; empty: there is none
  std::vector<Diagnostic> diagnostics;       // files of the list that are not there
};

// What Makefile.sources of `folder` names, whatever its variables are called: every word of an
// assignment that ends like a source; "$(wildcard ...)" stands for all.  Without that file, the C
// and C++ sources of the folder itself.
ControllerSources FindControllerSources(const std::filesystem::path& folder);

// Whether `folder` is that of a controller: it has a Makefile.sources, or a source that includes
// robot.h.
bool IsControllerFolder(const std::filesystem::path& folder);

}  // namespace openr_host
