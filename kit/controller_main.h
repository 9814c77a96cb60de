// Generates the function CallControllerMain(), which calls the main() of a controller.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace openr_host {

struct ControllerMain {
  std::string source;   // a source in C++ of 1998 that defines CallControllerMain()
  std::string problem;  // the reason why main() cannot be called, or ""
};

// Looks for main() in the object files of a controller, which were compiled with
// -Dmain=controller_main, and returns the source that calls this main().  `nm` is the program that
// lists symbols.  Without object files, the source calls nothing: the controller is empty.
ControllerMain FindControllerMain(const std::string& nm,
                                  const std::vector<std::filesystem::path>& objects);

}  // namespace openr_host
