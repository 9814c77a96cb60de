// What can be read from, and has to be changed in, Makefiles of old programs.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// Absolute paths of an SDK ("/usr/local/OPEN_R_SDK" in ".../bin/mipsel-linux-g++" or
// ".../OPEN_R/include", or standing alone) become `sdk_root`; those of a Memory Stick
// ("/mnt/ms" in "/mnt/ms/OPEN-R", but not the robot's own "/MS") become ${OPENR_KIT_STICK}; CR LF
// becomes LF.
std::string AdaptMakefile(const std::string& text, const std::string& sdk_root);

struct MakefileVariable {
  std::string name;
  bool is_defined = false;          // in the text, by any kind of assignment
  std::vector<std::string> values;  // as written, one per assignment
  std::string folder;               // below what it stands for: "" or "/OPEN_R/bin"
};

// Variables that stand for the SDK or a folder of it, by how they are used: $(X)/OPEN_R/lib,
// $(X)/mipsel-linux-g++, $(X)/mkbin.
std::vector<MakefileVariable> SdkVariables(const std::string& text);

// Variables that stand for the root of a Memory Stick: $(X)/OPEN-R/MW/OBJS.
std::vector<MakefileVariable> StickVariables(const std::string& text);

// Whether the text assigns to a variable of this name.
bool IsDefinedIn(const std::string& text, const std::string& name);

// File names of images that rules write below OPEN-R/MW/OBJS: "HELLO.BIN".
std::vector<std::string> InstalledImages(const std::string& text);

// Relative paths that begin with "../".
std::vector<std::string> UpwardPaths(const std::string& text);

}  // namespace openr_host
