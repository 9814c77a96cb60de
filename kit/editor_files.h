// The files by which Visual Studio Code builds, runs, tests and debugs a folder of objects or a
// controller.
#pragma once

#include <string>
#include <vector>

#include "kit/new_object.h"

namespace openr_host {

// Absolute paths of this installation of openr-host, which EditorFiles() writes into the editor's
// files.
struct EditorPlaces {
  std::string program;   // absolute path of the program openr
  std::string prefix;    // absolute path of the folder where CMake finds openr-host
  std::string printers;  // absolute path of the pretty printers of gdb; "": none
  std::string headers;   // absolute path of the folder of the headers for controllers
};

// Facts about the folder of a program or controller, on which the content of its files for the
// editor depends.
struct EditorFolder {
  bool is_controller = false;  // true: built by `openr controller build`; false: by `openr build`
  std::string stick = "MS";    // path of the stick relative to the folder; ".": the folder itself
  bool has_tests = true;       // true: CMakeLists.txt uses openr-host, so the folder has tests
};

// Returns the paths of this installation.
EditorPlaces FindEditorPlaces();

// Describes the folder of an existing program or controller.  If the folder has several sticks,
// EditorFolder::stick is the stick nearest to `folder`.  Throws std::runtime_error if `folder` has
// nothing that openr build or openr controller build could build.
EditorFolder DescribeEditorFolder(const std::string& folder);

// Returns the files tasks.json, launch.json, settings.json and extensions.json of the folder
// .vscode.  The paths that these files contain begin with ${workspaceFolder}, which is the folder
// that is open in the editor.
std::vector<NewFile> EditorFiles(const EditorPlaces& places, const EditorFolder& folder);

}  // namespace openr_host
