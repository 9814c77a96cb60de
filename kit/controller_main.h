// CallControllerMain(): the call of a controller's main(), generated when the controller is built.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace openr_host {

struct ControllerMain {
  std::string source;   // C++ of 1998 that defines CallControllerMain()
  std::string problem;  // "" or why the controller cannot be called
};

// Looks for main() in the object files of a controller, which were compiled with
// -Dmain=controller_main.  `nm` is the program that lists their symbols.  Without object files the
// result is the empty controller, which calls nothing.
ControllerMain FindControllerMain(const std::string& nm,
                                  const std::vector<std::filesystem::path>& objects);

}  // namespace openr_host
