// Translates a command line of mkbin, the SDK's tool that links an image, into a command line of
// the host's linker.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace openr_host {

struct LinkCommand {
  std::string output;                  // value of -o
  std::string ocf;                     // path of the .ocf file
  std::string map;                     // value of -m, a file for the list of addresses; "": none
  std::vector<std::string> objects;    // object files, in order
  std::vector<std::string> libraries;  // archives that are given by name or found for -l
  bool is_verbose = false;             // true: -v was given
};

// Translates `arguments`, the arguments of mkbin.  `exists` returns whether a file exists.  A
// library (-l) that is in no folder of -L belongs to the SDK.  Such a library is left out, because
// the runtime has its functions.
LinkCommand TranslateMkbin(const std::vector<std::string>& arguments,
                           const std::function<bool(const std::string& file)>& exists);

// Returns the names in the linker's messages about undefined references, each once, in order.
std::vector<std::string> UndefinedNames(const std::string& output);

}  // namespace openr_host
