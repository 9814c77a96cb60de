// The command `openr controller build`: makes the image CONTROLL.BIN from a Webots-style controller
// and puts it on a Memory Stick.
#pragma once

#include <string>

namespace openr_host {

struct ControllerBuildOptions {
  std::string folder;  // folder of the controller
  std::string output;  // folder of the stick, which holds OPEN-R/; "": `folder` itself
  // Path of a stick that is copied to `output` if `output` has no stick yet.
  std::string template_stick;
};

// Builds the controller, puts CONTROLL.BIN and the folder's WLANCONF.TXT and *.MTN on the stick,
// and prints the result.  Returns the exit code.  If the controller cannot be built, the stick does
// not change.  Throws std::runtime_error when the build cannot begin.
int BuildController(const ControllerBuildOptions& options);

}  // namespace openr_host
