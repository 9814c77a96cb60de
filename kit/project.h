// What lies in a folder of OPEN-R programs: objects, Memory Sticks, Makefiles.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/config/object_config.h"

namespace openr_host {

// A folder with a stub.cfg, or with a stub written by hand.
struct ObjectFolder {
  std::filesystem::path folder;
  std::filesystem::path stub;  // empty: written by hand
  std::string class_name;      // of stub.cfg
  std::vector<std::filesystem::path> ocfs;
  std::vector<std::filesystem::path> sources;  // of this folder only; without generated ones
  std::vector<std::string> image_names;        // which rules of its Makefile install
};

// A folder that holds OPEN-R/MW.
struct StickFolder {
  std::filesystem::path root;
  std::vector<ObjectRecord> objects;    // of OBJECT.CFG, for every robot design, in file order
  std::filesystem::path object_config;  // empty: there is none

  // OPEN-R/MW/OBJS as it is spelt there.
  std::filesystem::path ObjectsFolder() const;
};

struct Project {
  std::filesystem::path root;
  std::vector<ObjectFolder> objects;     // in order of names
  std::vector<ObjectFolder> neighbours;  // objects outside of the root, if the root has some
  std::vector<StickFolder> sticks;
  std::vector<std::filesystem::path> makefiles;       // all of them, included ones too
  std::vector<std::filesystem::path> shared_sources;  // in no object's own folder
  std::vector<std::filesystem::path> header_folders;  // outside of objects' own folders
};

// Reads `folders`: the first is the project's root, the others are what it refers to, of which
// objects and sticks count only if the root has none.
Project ScanProject(const std::vector<std::filesystem::path>& folders);

// Whether the text of a def.h comes from stubgen2, of whatever time.
bool IsGeneratedDefinitions(const std::string& text);

// The file name of a robot path: "/MS/OPEN-R/MW/OBJS/HELLO.BIN" is HELLO.BIN.
std::string FileNameOf(const ObjectRecord& record);

}  // namespace openr_host
