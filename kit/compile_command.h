// Translates a command line of the robot's compiler into a command line of the host's compiler.
#pragma once

#include <string>
#include <vector>

#include "kit/sdk_paths.h"

namespace openr_host {

// The parts of a command line of the robot's g++ or gcc.
struct CompileCommand {
  // Arguments for the host's compiler.  On its command line, these arguments follow the flags that
  // are in the file compile-flags.txt.
  std::vector<std::string> arguments;
  std::vector<std::string> sources;  // files to compile, in the order given
  std::string output;                // value of -o; "" if not given
  bool compiles = false;             // true: the command makes object files or assembly (-c, -S)
  // True: the command links a program, because it has no flag such as -c, -S, -E or --version.
  bool links = false;
  bool is_quiet = false;               // true: -w was given, so warnings are not shown
  Language language = Language::kCxx;  // language of the sources
};

// Translates `arguments`.  Leaves out flags that mean nothing on the host: flags for the processor
// (-mips3, -G 0, -EL), -Werror and -ansi.  Replaces -I- by today's flags, and the level in -std by
// the level that means the same for today's compiler.  `is_cxx` is true for the command g++, which
// compiles .c files as C++, and false for gcc.
CompileCommand TranslateCompile(const std::vector<std::string>& arguments, bool is_cxx);

// Returns the flags among `arguments` that change the meaning of a source: -D, -U, -I, -include,
// -std and the like.  Names of files and folders in these flags become absolute; relative names
// count from `folder`.
std::vector<std::string> CarriedFlags(const std::vector<std::string>& arguments,
                                      const std::string& folder);

// Returns the flags that the host's compiler does not know, according to its messages `output`.
std::vector<std::string> UnknownFlags(const std::string& output);

// Flag of g++: functions of the C++ library do not call the helpers that -finstrument-functions
// asks for (image_source.cc).  These functions need no helpers, because none of them lacks a return
// statement.  Without this flag, a source that includes <iostream> would take up to three times as
// long to compile.
inline constexpr char kNoHelpersInLibrary[] =
    "-finstrument-functions-exclude-file-list=/usr/include/c++/";

// Returns whether `output`, messages of the compiler, warns of a function that may end without
// returning a value.
bool TellsOfMissingReturn(const std::string& output);

}  // namespace openr_host
