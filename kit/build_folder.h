// The command openr build: makes Memory Sticks that run on this host from a folder of OPEN-R
// programs.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct BuildOptions {
  std::string folder;  // folder to build
  std::string output;  // folder for the stick; "": the stick in `folder`
  std::string work;    // folder for private copies; "": one in the user's cache
  int jobs = 0;        // make jobs at a time; 0: one per processor
  bool is_verbose = false;
  bool is_fresh = false;  // discards what earlier builds left
};

// Builds and reports the result.  Returns the exit code: 0 if there is an image for every line of
// each OBJECT.CFG.  Throws std::runtime_error when the folder cannot be used at all.
int BuildFolder(const BuildOptions& options);

}  // namespace openr_host
