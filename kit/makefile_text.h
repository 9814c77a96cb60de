// Reads Makefiles of old programs, and adapts them to the host.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// Returns the Makefile `text`, adapted to this computer:
//   - a path of an SDK ("/usr/local/OPEN_R_SDK" in ".../bin/mipsel-linux-g++" or in
//     ".../OPEN_R/include", or alone) becomes `sdk_root`;
//   - a path of a Memory Stick ("/mnt/ms" in "/mnt/ms/OPEN-R", but not the robot's own "/MS")
//     becomes ${OPENR_KIT_STICK};
//   - CR LF becomes LF.
// A word of more than 4096 characters stays as it is, because it can be no path.
std::string AdaptMakefile(const std::string& text, const std::string& sdk_root);

// Returns `text`, the text of a Makefile, without its words of more than 4096 characters, which can
// be no paths.  std::regex calls itself for each character that it matches, so a search for paths
// in such long words could overflow the stack.
std::string WithoutLongWords(const std::string& text);

// A variable of a Makefile that stands for a folder of the SDK, or for a Memory Stick.
struct MakefileVariable {
  std::string name;
  bool is_defined = false;  // true: the text assigns a value to the variable (=, := or the like)
  std::vector<std::string> values;  // the values as written, one per assignment
  // The folder inside the SDK for which the variable stands, as a path from the root of the SDK,
  // such as "/OPEN_R/bin"; "" if the variable stands for the root, or for a Memory Stick.
  std::string folder;
};

// Returns the variables in `text`, the text of Makefiles, that stand for the SDK's folder or a
// folder in it.  The text after a variable shows the folder: $(X)/OPEN_R/lib means that X is the
// SDK, $(X)/mkbin that X is its folder OPEN_R/bin.
std::vector<MakefileVariable> SdkVariables(const std::string& text);

// Returns the variables in `text`, the text of Makefiles, that stand for the root of a Memory
// Stick, as in $(X)/OPEN-R/MW/OBJS.
std::vector<MakefileVariable> StickVariables(const std::string& text);

// Returns whether `text`, the text of Makefiles, assigns a value to a variable of this name.
bool IsDefinedIn(const std::string& text, const std::string& name);

// Returns the file names of images that rules of the Makefile `text` write below OPEN-R/MW/OBJS,
// such as "HELLO.BIN".
std::vector<std::string> InstalledImages(const std::string& text);

// Returns the paths in the Makefile `text` that begin with "..", such as "../common".
std::vector<std::string> UpwardPaths(const std::string& text);

}  // namespace openr_host
