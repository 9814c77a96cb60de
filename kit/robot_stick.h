// The command `openr stick`: makes the files of a Memory Stick, for the robot or for the host.
#pragma once

#include <string>

namespace openr_host {

struct RobotStickOptions {
  std::string output;      // folder to create; OPEN-R/ will be in it
  std::string controller;  // folder of a controller; "": the empty controller
  std::string base;        // folder whose OPEN-R/ has the system files; "": those of the SDK
  std::string model = "ers210";
  std::string flavour = "WCONSOLE";
  bool is_protected = true;  // true: takes the system files with memory protection
  bool is_verbose = false;
  std::string sources;  // folder with the sources of the objects and stub.cfg/ (install_paths.h)
  std::string stick;    // default stick of the host; the motions are taken from it
};

// Compiles the objects with the robot's SDK, which the environment variable OPENRSDK_ROOT names,
// and adds them to the base of a stick, the system files with which the stick begins.  If anything
// fails, no output is left.  Throws std::runtime_error with the reason of a failure.
void MakeRobotStick(const RobotStickOptions& options);

// Copies `stick` to `output`.  Leaves out the files that only a debugger on the host reads.  If
// anything fails, no output is left.
void MakeHostStick(const std::string& stick, const std::string& output);

}  // namespace openr_host
