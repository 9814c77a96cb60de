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

struct PlacedImage {
  std::string name;    // file name of the image, such as HELLO.BIN
  std::string object;  // name of the image's object; "" if this build has not made the image
  // How the image for a name in OBJECT.CFG was found: "Makefile", "by its name", "the kit's own"
  // and others.
  std::string from;
};

struct CompletedStick {
  std::vector<PlacedImage> images;
  std::vector<std::string> problems;  // error messages, each of one line
  std::vector<std::string> notes;
  // Files that CompleteStick() has put on the stick, without the files that rules of Makefiles have
  // put on the stick.  The next build removes the files of this list, so that they do not count as
  // images of that build.
  std::vector<std::filesystem::path> placed;
  std::set<std::string> used;  // paths (KitLog::Image::file) of the images on the stick
};

// Puts on `stick` the images that its OBJECT.CFG names and that no rule of a Makefile has put on
// the stick.  `stick` is in the private copy of the user's folder, and `users_stick` is its
// original; the path is empty if there is no original.  If the stick has no OBJECT.CFG, writes an
// OBJECT.CFG, and adds a note about each image in the stick's folder OBJS that this OBJECT.CFG does
// not name, with the reason.  If there are several sticks, first takes images that were built
// nearer to this stick than to other sticks in the tree of folders.  Takes images that were built
// elsewhere only for the names that are then still without an image.  An image that a Makefile puts
// on one stick has the same file name on all other sticks.
CompletedStick CompleteStick(const StickFolder& stick, const Project& project, const KitLog& log,
                             const std::string& sdk_root, const std::filesystem::path& users_stick);

// Deletes `images`, which are out of date.  Deletes the file that the linker wrote, and every file
// with the same content on the sticks of `project`.
void RemoveImages(const std::vector<KitLog::Image>& images, const Project& project);

// Copies the files of `stick`, which is in the private copy, to `target`, the user's stick or
// another folder.  Leaves out files that the build has not changed, unless `whole` is set.  Before
// a binary for the robot is overwritten, copies it to `robot_folder`, where each version of it is
// kept: the second of WALK.BIN as WALK.BIN.2.  Also creates the folder in
// which programs write files.  Returns the error messages, each of one line.
std::vector<std::string> DeliverStick(const StickFolder& stick, const std::filesystem::path& target,
                                      const WorkCopy& copy,
                                      const std::filesystem::path& robot_folder, bool whole);

}  // namespace openr_host
