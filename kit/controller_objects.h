// Compiles the sources of a controller.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "kit/sdk_tools.h"

namespace openr_host {

// Compiles the controller in `folder`: its `sources`, and the generated function
// CallControllerMain() (objects/Controller/ControllerMain.h).  `flags` are further flags of the
// compiler.  Returns the object files, which are in the folder `scratch`; nullopt after printing
// errors.  Throws std::runtime_error if a file cannot be written.
std::optional<Arguments> CompileController(const std::vector<std::filesystem::path>& sources,
                                           const std::filesystem::path& folder,
                                           const std::filesystem::path& scratch,
                                           const Arguments& flags = {});

}  // namespace openr_host
