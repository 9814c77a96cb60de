// Copies the results of a build to the user's Memory Sticks.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "kit/kit_log.h"
#include "kit/project.h"
#include "kit/work_copy.h"

namespace openr_host {

struct HarvestedImage {
  std::string name;    // HELLO.BIN
  std::string object;  // name of its object in the .ocf file; "": not built by this build
  std::string from;  // where the image came from: "Makefile", "found by name", "the kit's own", ...
};

struct Harvest {
  std::vector<HarvestedImage> images;
  std::vector<std::string> problems;  // lines for the user
  std::vector<std::string> notes;
  // Files that this function, and no rule of a Makefile, has put on the stick.
  std::vector<std::filesystem::path> placed;
  std::set<std::string> used;  // images of the log that are on the stick
};

// Adds the images that OBJECT.CFG of the stick names and that the Makefiles did not put there.
// `stick` is the private copy.  A stick without OBJECT.CFG gets one with all images.  With several
// sticks, each gets the images of the folders around it first.  An image name that a Makefile uses
// for one stick is used for the others too.
Harvest CompleteStick(const StickFolder& stick, const Project& project, const KitLog& log,
                      const std::string& sdk_root);

// Removes images that are out of date, both where they were linked and on the sticks of the copy.
void RemoveImages(const std::vector<KitLog::Image>& images, const Project& project);

// Copies new files from the stick of the private copy to `target`, which is the user's stick or
// another folder; copies all files if `whole` is set.  Binaries for the robot that would be
// overwritten are moved to `robot_folder`.  Makes the folders that programs write to.  Returns the
// problems, a line each.
std::vector<std::string> DeliverStick(const StickFolder& stick, const std::filesystem::path& target,
                                      const WorkCopy& copy,
                                      const std::filesystem::path& robot_folder, bool whole);

}  // namespace openr_host
