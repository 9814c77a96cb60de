// Checks that a Memory Stick has the files that a robot needs to boot from it.  A host does not
// need these files.
#pragma once

#include <cstdint>
#include <string>

#include "kit/remarks.h"

namespace openr_host {

// The content of a stick in a folder, for a summary.
struct StickSummary {
  std::string base;  // name of the base image, such as "WCONSOLE"; "": none
  int num_files = 0;
  uint64_t num_bytes = 0;
  // Number of images that OBJECT.CFG names and that are on the stick.  The base image, which is the
  // robot's system, does not count.
  int num_images = 0;
  uint64_t image_bytes = 0;
};

// Returns whether the folder `root`, which holds OPEN-R/, has at least a part of a base image,
// which is the robot's system.
bool HasBaseImage(const std::string& root);

// Returns a text for the end of an error message.  It lists the files that a base image has, and
// names the folders of the SDK in which there are base images.
std::string BaseImageContents();

// Adds a remark (an error, a warning or a note) for each part of the robot's system that is missing
// on the stick in the folder `root`, which holds OPEN-R/.  These parts are the base image with its
// system objects, DESIGN.CFG for `design` ("ERS-210"; "": any design), images for the robot's
// processor, and the network if an object needs it.
StickSummary CheckBoot(const std::string& root, const std::string& design, Remarks* remarks);

}  // namespace openr_host
