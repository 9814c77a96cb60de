// Loads the objects, connections and design data that the Memory Stick of a robot names.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace openr_host {

class System;

// Functions that are called instead of loading an image, for objects that run in a worker process
// and for objects that a test replaces.  The key is the name of the object in the image
// ("JointMover") or of the file ("JOINTMOV.BIN").  A function gets the path of the image and may
// add another object in its place.
using StandIns = std::map<std::string, std::function<void(const std::string& path)>>;

// A part of the system that is an image on a robot and part of the runtime here.
struct SystemImage {
  std::string file;           // the name of the image in OBJECT.CFG: "TCPGW.BIN"
  std::function<void()> add;  // adds the object; called instead of loading the image
  // compares the part with the rest of the stick; called after everything else was loaded
  std::function<void()> check;
};

// Loads the images that OBJECT.CFG names, and adds the connections of CONNECT.CFG and the keywords
// of DESIGNDB.CFG to the system.  Each problem becomes a finding with file:line.  A stand-in for
// the file of a system image is called in place of its `add`.  Returns false if the robot would not
// boot, because an image is missing or cannot be loaded.  REQUIRES: before System::Boot().
bool LoadStick(System* system, int robot, StandIns stand_ins = {},
               const std::vector<SystemImage>& system_images = {});

}  // namespace openr_host
