// Compiles the sources of a controller.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "kit/sdk_tools.h"

namespace openr_host {

// Compiles `sources` of the controller in `folder`, with the further flags `flags`, and the
// generated function CallControllerMain() (objects/Controller/ControllerMain.h), into the folder
// `scratch`. Returns the object files; nullopt after printing errors.  Throws std::runtime_error if
// a file cannot be written.
std::optional<Arguments> CompileController(const std::vector<std::filesystem::path>& sources,
                                           const std::filesystem::path& folder,
                                           const std::filesystem::path& scratch,
                                           const Arguments& flags = {});

}  // namespace openr_host
