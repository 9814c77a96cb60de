// openr new: an object to begin with.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct NewFile {
  std::string path;  // relative
  std::string text;
};

// Why `name` cannot be the name of an object, or "".
std::string WhyNoObjectName(const std::string& name);

// A folder with the object `name`: stub.cfg, sources, .ocf file, a Memory Stick tree that connects
// it to the robot's sensors, a Makefile for the robot's SDK and ours, a CMakeLists.txt, a test with
// openr::testing.
std::vector<NewFile> MakeNewObject(const std::string& name);

// Writes them to `folder`.  Nothing that is there is overwritten: then nothing is written.
// Returns what went wrong, or "".
std::string WriteNewObject(const std::vector<NewFile>& files, const std::string& folder);

}  // namespace openr_host
