// Builds a controller as a shared library for this computer (openr controller run).
#pragma once

#include <string>

namespace openr_host {

// Name of the only function that the shared library of a controller exports: extern "C" int
// f(void).  The function calls main() of the controller.
inline constexpr char kControllerMainName[] = "openr_controller_main";

struct ControllerLibraryOptions {
  std::string source;          // folder of the controller, or one source file of it
  std::string device_library;  // path of libopenr_controller.so, which has the device functions
  std::string output;          // the file to write; object files go into its folder
};

// Returns the folder of a controller that is given as `source`: a folder or a source file.
std::string FolderOfController(const std::string& source);

// Builds the library.  Returns false after printing the compiler's or the linker's errors.  Throws
// std::runtime_error when the build cannot begin.
bool BuildControllerLibrary(const ControllerLibraryOptions& options);

}  // namespace openr_host
