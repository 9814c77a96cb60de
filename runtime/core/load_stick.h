// Loads the objects, connections and design data that the Memory Stick of a robot names.
#pragma once

#include <functional>
#include <map>
#include <string>

namespace openr_host {

class System;

// Functions that are called instead of loading an image.  The key is the name of the object in the
// image ("JointMover") or of the file ("JOINTMOV.BIN").  A function gets the path of the image and
// may add other objects in its place.
using StandIns = std::map<std::string, std::function<void(const std::string& path)>>;

// Loads the images that OBJECT.CFG names, and adds the connections of CONNECT.CFG and the keywords
// of DESIGNDB.CFG to the system.  Each problem becomes a finding with file:line.  Returns false if
// the robot would not boot, because an image is missing or cannot be loaded.  REQUIRES: before
// System::Boot().
bool LoadStick(System* system, int robot, const StandIns& stand_ins = {});

}  // namespace openr_host
