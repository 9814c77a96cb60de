// The command `openr new`: makes the files of a new object.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct NewFile {
  std::string path;  // path of the file, below the folder of the object
  std::string text;
};

// Returns the reason why `name` cannot be the name of an object; "" if it can.
std::string ObjectNameProblem(const std::string& name);

// Compiles a class with the name of the object `name`, with the headers of the SDK tree `sdk_root`.
// Returns the reason why no class can have this name; "" if the class compiles, or if no class
// compiles because there is no compiler.
std::string ClassNameProblem(const std::string& name, const std::string& sdk_root);

// Name of the file that tells git which files of builds and runs are not to be committed.
inline constexpr char kIgnoreFile[] = ".gitignore";

// Returns the files of a folder with the object `name`: stub.cfg, sources, .ocf file, a Memory
// Stick tree that connects the object to the robot's sensors, a Makefile for both SDKs (the robot's
// and ours), a CMakeLists.txt, a .gitignore, and a test with openr::testing.
std::vector<NewFile> MakeNewObject(const std::string& name);

// Writes the files to `folder`.  If one of the files exists already, writes no file.  If a file
// cannot be written, removes the files that it has written before.  Returns "" or the error
// message.
std::string WriteNewObject(const std::vector<NewFile>& files, const std::string& folder);

}  // namespace openr_host
