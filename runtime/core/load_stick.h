// LoadStick(): loads the objects, the connections and the design data (files that programs find by
// keywords) that the configuration files on a robot's Memory Stick name.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace openr_host {

class System;

// Functions that LoadStick() calls in place of loading an image.  They are used for objects that
// run in a worker process, and for objects that a test replaces.  The key is the name of the object
// in the image ("JointMover") or the name of the file ("JOINTMOV.BIN").  A function gets the path
// of the image and may add another object to the system.
using StandIns = std::map<std::string, std::function<void(const std::string& path)>>;

// A part of the system that is an image on the robot and is built into the runtime here, such as
// the network gateway.
struct SystemImage {
  std::string file;           // the name of the image in OBJECT.CFG: "TCPGW.BIN"
  std::function<void()> add;  // adds the object; called instead of loading the image
  // Adds findings if other files of the stick, such as CONNECT.CFG, do not fit this system image.
  // Called after the whole stick was loaded.
  std::function<void()> check;
};

// Loads the images that OBJECT.CFG names, and adds the connections of CONNECT.CFG and the keywords
// of DESIGNDB.CFG to the system.  Each problem becomes a finding with file:line.
//
// If `stand_ins` has a function for an image, calls this function in place of loading the image.
// For a system image without such a function, calls SystemImage::add.
//
// If an image cannot be loaded, loads the file of the same name with the ending .OLD, but not with
// SystemOptions::strict.  RCServer gives this ending to the old image when an upload replaces it.
// Returns false if OBJECT.CFG cannot be read, or if neither an image nor its .OLD file can be
// loaded.  REQUIRES: before System::Boot(), or in Robot::load_again.
bool LoadStick(System* system, int robot, StandIns stand_ins = {},
               const std::vector<SystemImage>& system_images = {});

}  // namespace openr_host
