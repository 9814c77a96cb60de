// From what a build made to the person's Memory Sticks.
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
  std::string object;  // its name in the .ocf file; "" when it is not of this build
  std::string from;    // "Makefile", "found by name", "the kit's own", ...
};

struct Harvest {
  std::vector<HarvestedImage> images;
  std::vector<std::string> problems;  // a line each, for people
  std::vector<std::string> notes;
  std::vector<std::filesystem::path> placed;  // files that no rule of a Makefile made
  std::set<std::string> used;                 // images of the log that are on the stick
};

// Puts into the stick of the copy what its OBJECT.CFG names and the Makefiles did not put there.
// A stick without OBJECT.CFG gets one that lists everything.  Of several sticks, each gets the
// images of the folders around it first, and names that Makefiles use on one serve the others.
Harvest CompleteStick(const StickFolder& stick, const Project& project, const KitLog& log,
                      const std::string& sdk_root);

// Removes images that are out of date, from the folders where they were linked and from the sticks
// of the copy.
void RemoveImages(const std::vector<KitLog::Image>& images, const Project& project);

// Brings what is new in the stick of the copy to `target`, the person's own or another folder;
// binaries for the robot that are in the way are kept in `robot_folder`.  Everything is brought,
// not only what is new, when `whole` is set.  The stick has the folders that programs write to.
// Returns what went wrong, a line each.
std::vector<std::string> DeliverStick(const StickFolder& stick, const std::filesystem::path& target,
                                      const WorkCopy& copy,
                                      const std::filesystem::path& robot_folder, bool whole);

}  // namespace openr_host
