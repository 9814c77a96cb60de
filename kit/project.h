// Finds the parts of a folder of OPEN-R programs: objects, Memory Sticks, Makefiles.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/config/object_config.h"

namespace openr_host {

// The folder of an object.  It has a stub.cfg, from which stubgen2 makes the stub (the table of the
// object's handlers), or a source with a stub written by hand.
struct ObjectFolder {
  std::filesystem::path folder;
  std::filesystem::path stub;  // path of stub.cfg; empty: the stub is written by hand
  std::string class_name;      // name of the object's class, from stub.cfg
  std::vector<std::filesystem::path> ocfs;
  std::vector<std::filesystem::path> sources;  // sources in this folder, without generated files
  std::vector<std::string> image_names;        // images that rules of its Makefile install
};

// A Memory Stick in the form of a folder.  This folder holds OPEN-R/MW.
struct StickFolder {
  std::filesystem::path root;
  std::vector<ObjectRecord> objects;    // lines of OBJECT.CFG in their order, for all robots
  std::filesystem::path object_config;  // path of OBJECT.CFG; empty: the stick has none

  // Returns the path of OPEN-R/MW/OBJS, with upper and lower case letters as on the disk.
  std::filesystem::path ObjectsFolder() const;
};

struct Project {
  std::filesystem::path root;
  std::vector<ObjectFolder> objects;  // the objects, sorted by folder
  // Objects in folders outside of `root`, which are not built.  If `root` has no objects, the
  // objects outside of `root` are in `objects` and are built, and `neighbours` is empty.
  std::vector<ObjectFolder> neighbours;
  std::vector<StickFolder> sticks;
  std::vector<std::filesystem::path> makefiles;  // all Makefiles, also those that others include
  std::vector<std::filesystem::path> shared_sources;  // sources in folders that belong to no object
  // Folders that have headers and belong to no object.  The compiler searches them for every
  // object.
  std::vector<std::filesystem::path> header_folders;
};

// Finds the parts of a program in `folders`.  The first folder is the root of the project.  The
// other folders are outside of the root, and files in the root name them.  Objects and sticks in
// these folders are used only if the root has none.
Project ScanProject(const std::vector<std::filesystem::path>& folders);

// Throws std::runtime_error if `project` has nothing that can be built.  `folder` is the user's
// folder, also if `project` describes the private copy of this folder; the error message names
// `folder`.
void CheckProjectHasProgram(const Project& project, const std::filesystem::path& folder);

// Throws std::runtime_error if `folder`, the user's folder, cannot be read or has nothing that can
// be built.  Called before the folder is copied, because a folder without a program, such as a home
// folder, may be large.
void CheckFolderHasProgram(const std::filesystem::path& folder);

// Returns whether the text of a def.h was written by stubgen2, of any version.
bool IsGeneratedDefinitions(const std::string& text);

// Returns the file name of the image in `record`, a line of OBJECT.CFG: "HELLO.BIN" for the path
// "/MS/OPEN-R/MW/OBJS/HELLO.BIN".
std::string FileNameOf(const ObjectRecord& record);

}  // namespace openr_host
