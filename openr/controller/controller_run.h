// The interface of libopenr_controller.so, which the program loads only for `openr controller run`.
//
// The library has the functions of objects/Controller/include/device for a controller that runs on
// this computer and commands a robot through openr::remote.  The controller itself is another
// shared library, linked with this one (kit/controller_library.h).
#pragma once

#include <cstdint>

namespace openr_host {

struct ControllerRun {
  const char* address;       // address of the robot's remote control: "HOST[:PORT]"
  int64_t timeout_ms;        // time limit for each answer of the robot
  const char* token;         // token, the secret that the robot's server asks for; "": no token
  const char* folder;        // folder of the controller, which has its motion files (*.MTN)
  int (*controller_main)();  // a function that calls main() of the controller
};

// Runs the controller until its loop ends, Ctrl-C is pressed, or the connection ends.  Prints
// errors and the achieved time step on standard error.  Returns the exit status.  If the controller
// waits in robot_step() at the end, the process exits with this status instead of returning.
using RunController = int(const ControllerRun& run);
inline constexpr char kRunControllerName[] = "openr_run_controller";

}  // namespace openr_host
