// The files by which Visual Studio Code builds, runs, tests and debugs a new object.
#pragma once

#include <string>
#include <vector>

#include "kit/new_object.h"

namespace openr_host {

// Paths of the installation that the files for the editor contain.
struct EditorPlaces {
  std::string program;   // absolute path of the program openr
  std::string prefix;    // absolute path of the folder where CMake finds openr-host
  std::string printers;  // absolute path of the pretty printers of gdb; "": none
};

// Returns .vscode/tasks.json, launch.json, settings.json and extensions.json.  Their paths begin
// with ${workspaceFolder}, the folder that is open in the editor.
std::vector<NewFile> EditorFiles(const EditorPlaces& places);

}  // namespace openr_host
