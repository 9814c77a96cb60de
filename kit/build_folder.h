// openr build: from a folder of OPEN-R programs to Memory Sticks that run here.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct BuildOptions {
  std::string folder;  // what to build
  std::string output;  // where the stick goes; "": the one in the folder
  std::string work;    // for private copies; "": a folder of its own in the person's cache
  int jobs = 0;        // 0: as many as there are processors
  bool is_verbose = false;
  bool is_fresh = false;  // forgets what earlier builds left
};

// Builds, says what became of it, and returns the exit code: 0 if every image that an OBJECT.CFG
// names is there.  Throws std::runtime_error when the folder cannot be used at all.
int BuildFolder(const BuildOptions& options);

}  // namespace openr_host
