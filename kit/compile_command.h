// From a command line for the robot's compiler to one for the host's.
#pragma once

#include <string>
#include <vector>

#include "kit/sdk_paths.h"

namespace openr_host {

// A command line of the robot's g++ or gcc, taken apart.
struct CompileCommand {
  std::vector<std::string> arguments;  // for the host, without the flags of compile-flags.txt
  std::vector<std::string> sources;    // files to compile, in order
  std::string output;                  // of -o; "" if not given
  bool compiles = false;               // makes object files: -c, or -S
  bool links = false;                  // neither that nor only preprocesses nor only asks
  bool is_quiet = false;               // -w was given
  Language language = Language::kCxx;  // of the sources
};

// Takes out what means nothing on the host: flags for the processor (-mips3, -G 0, -EL), -Werror
// and -ansi.  -I- is said in today's way, and -std as a level of today's compiler that means the
// same. `is_cxx`: the driver was g++, which takes .c for C++.
CompileCommand TranslateCompile(const std::vector<std::string>& arguments, bool is_cxx);

// The flags among `arguments` that say what a source means: -D, -U, -I, -include and -std and the
// like.  Folders and files that they name are made absolute; they are relative to `folder`.
std::vector<std::string> CarriedFlags(const std::vector<std::string>& arguments,
                                      const std::string& folder);

// Flags the host's compiler says it does not know in `output`, its complaint.
std::vector<std::string> UnknownFlags(const std::string& output);

// True when `output` warns of a function that ends without the value it should return.
bool TellsOfMissingReturn(const std::string& output);

}  // namespace openr_host
