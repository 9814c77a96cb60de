// openr stick: the files for a Memory Stick, for the robot or for the host.
#pragma once

#include <string>

namespace openr_host {

struct RobotStickOptions {
  std::string output;      // folder to make; holds OPEN-R/ afterwards
  std::string controller;  // folder of a controller; "": the default one, which does nothing
  std::string base;        // folder with OPEN-R/ to add to; "": the SDK's
  std::string model = "ers210";
  std::string flavour = "WCONSOLE";
  bool is_protected = true;  // memory protection
  bool is_verbose = false;
  std::string sources;  // the objects' sources, with stub.cfg/ (install_paths.h)
  std::string stick;    // the default stick of the host: motions come from there
};

// Compiles the objects with the SDK of OPENRSDK_ROOT and puts them on the base of a stick.  The
// output appears whole or not at all.  Throws std::runtime_error that says what is wrong.
void MakeRobotStick(const RobotStickOptions& options);

// A copy of `stick` in `output`, whole or not at all; without what only the host's debugger reads.
void MakeHostStick(const std::string& stick, const std::string& output);

}  // namespace openr_host
