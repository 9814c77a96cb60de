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
  // How the image was found: "Makefile" (a rule has put the image on the stick), "by its name" (an
  // image of this build with a name that fits), "the kit's own" (an image of the SDK tree), or "the
  // runtime's own" (the gateway).
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
// the stick.  `stick` is in the private copy of the user's folder; `users_stick` is the original of
// `stick`, or empty if there is no original.  If `stick` has no OBJECT.CFG, writes one.  Then adds
// a note, with the reason, about each image in the stick's folder OBJS that the new OBJECT.CFG does
// not name.
//
// Finds the images of the build by comparing names.  A first round uses only the images to which no
// other stick is nearer in the tree of folders.  A second round uses all images, for the names in
// OBJECT.CFG that still have no image.  If a Makefile puts an image on any stick, the file name on
// that stick counts as a name of the image.
CompletedStick CompleteStick(const StickFolder& stick, const Project& project, const KitLog& log,
                             const std::string& sdk_root, const std::filesystem::path& users_stick);

// Deletes `images`, which are out of date.  Deletes the file that the linker wrote, and every file
// with the same content on the sticks of `project`.
void RemoveImages(const std::vector<KitLog::Image>& images, const Project& project);

// Copies the files of `stick`, which is in the private copy, to `target`, the user's stick or
// another folder.  Leaves out files that the build has not changed, unless `whole` is set.  Before
// an image for the robot is overwritten, copies that image to `robot_folder`, where each version of
// an image is kept: the second version of WALK.BIN as WALK.BIN.2.  Also creates the folder in which
// programs write files.  Returns the error messages, each of one line.
std::vector<std::string> DeliverStick(const StickFolder& stick, const std::filesystem::path& target,
                                      const WorkCopy& copy,
                                      const std::filesystem::path& robot_folder, bool whole);

}  // namespace openr_host
