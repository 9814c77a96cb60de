// The command `openr build`: builds the OPEN-R programs in a folder for this computer, and puts
// them on their Memory Sticks (folders that contain OPEN-R/).
#pragma once

#include <string>

#include "kit/build_variant.h"

namespace openr_host {

struct BuildOptions {
  std::string folder;  // folder to build
  std::string output;  // folder for the finished stick; "": writes into the stick in `folder`
  std::string work;    // folder for private copies; "": a folder in the user's cache
  int jobs = 0;        // number of jobs that make runs at a time; 0: one job per processor
  bool is_verbose = false;
  BuildVariant variant = BuildVariant::kPlain;
  bool writes_database = false;  // true: writes compile_commands.json into the folder
  bool is_fresh = false;         // true: removes the results of earlier builds first
};

// Builds the folder and prints the result.  Returns the exit code, which is 0 if every image
// (program file) that an OBJECT.CFG lists is on its stick.  Throws std::runtime_error when the
// build cannot begin, such as when the folder has no program.
int BuildFolder(const BuildOptions& options);

}  // namespace openr_host
