// Translates a command line of the robot's compiler into one of the host's compiler.
#pragma once

#include <string>
#include <vector>

#include "kit/sdk_paths.h"

namespace openr_host {

// The parts of a command line of the robot's g++ or gcc.
struct CompileCommand {
  std::vector<std::string> arguments;  // for the host, without the flags of compile-flags.txt
  std::vector<std::string> sources;    // files to compile, in the order given
  std::string output;                  // value of -o; "" if not given
  bool compiles = false;               // makes object files or assembly (-c, -S)
  bool links = false;     // neither compiles only, nor preprocesses only, nor prints information
  bool is_quiet = false;  // -w was given
  Language language = Language::kCxx;  // language of the sources
};

// Translates `arguments`.  Flags that mean nothing on the host are left out: flags for the
// processor (-mips3, -G 0, -EL), -Werror and -ansi. -I- is replaced by today's flags, and -std by
// the level of today's compiler with the same meaning.  `is_cxx` says that the command was g++,
// which compiles .c files as C++, and not gcc.
CompileCommand TranslateCompile(const std::vector<std::string>& arguments, bool is_cxx);

// Returns the flags among `arguments` that change the meaning of a source: -D, -U, -I, -include,
// -std and the like.  Relative names of folders and files in these flags are relative to `folder`
// and become absolute.
std::vector<std::string> CarriedFlags(const std::vector<std::string>& arguments,
                                      const std::string& folder);

// Returns the flags that the host's compiler does not know, according to its messages `output`.
std::vector<std::string> UnknownFlags(const std::string& output);

// Returns whether `output` warns of a function that may end without returning a value.
bool TellsOfMissingReturn(const std::string& output);

}  // namespace openr_host
