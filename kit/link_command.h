// From a command line of mkbin to one for the host's linker.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace openr_host {

struct LinkCommand {
  std::string output;                  // of -o
  std::string ocf;                     // the .ocf file
  std::string map;                     // of -m: where to say what lies where; "" for nowhere
  std::vector<std::string> objects;    // object files, in order
  std::vector<std::string> libraries;  // archives: named ones and those found for -l
  bool is_verbose = false;             // -v
};

// `exists` tells whether a file is there.  A library that is found in no -L folder is one of the
// SDK's, which the runtime stands for, and is left out.
LinkCommand TranslateMkbin(const std::vector<std::string>& arguments,
                           const std::function<bool(const std::string& file)>& exists);

// The names in the linker's complaints of undefined references, each once, in order.
std::vector<std::string> UndefinedNames(const std::string& output);

}  // namespace openr_host
