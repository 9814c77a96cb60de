// openr controller build: CONTROLL.BIN from a Webots-style controller, on a Memory Stick.
#pragma once

#include <string>

namespace openr_host {

struct ControllerBuildOptions {
  std::string folder;          // the controller's
  std::string output;          // folder of the stick, which holds OPEN-R/; "": `folder` itself
  std::string template_stick;  // what a stick that is not there yet is copied from
};

// Builds, puts CONTROLL.BIN, WLANCONF.TXT and *.MTN of the folder on the stick, says so, and
// returns the exit code.  Nothing on the stick changes when the controller cannot be built.  Throws
// std::runtime_error when it cannot even be tried.
int BuildController(const ControllerBuildOptions& options);

}  // namespace openr_host
