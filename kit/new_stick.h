// Makes a Memory Stick tree for images that are built already.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct NewStickOptions {
  std::string output;               // folder to make; OPEN-R/ will be in it
  std::vector<std::string> images;  // .BIN files, in the order of OBJECT.CFG
  std::string connections;          // path of the CONNECT.CFG to copy; "": an empty file is made
  // Folder with a base image (the robot's system) in its OPEN-R/, which is copied to the stick;
  // "": the stick gets no base image
  std::string base;
  std::string wlan;  // text of WLANCONF.TXT; "": none is written
};

// Makes the stick completely or, if anything fails, not at all.  Returns the names of the images in
// OPEN-R/MW/OBJS of the base that the OBJECT.CFG of the stick does not name.  Throws
// std::runtime_error with the reason of a failure.
std::vector<std::string> MakeNewStick(const NewStickOptions& options);

// Writes `text` as the network settings of the stick in the folder `stick`, which holds OPEN-R/.
// Returns the path of the file.  Throws std::runtime_error if the file cannot be written.
std::string PutWlanFile(const std::string& stick, const std::string& text);

}  // namespace openr_host
