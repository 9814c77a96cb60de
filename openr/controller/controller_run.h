// What the program calls in libopenr_controller.so, which it loads only for `openr controller run`.
//
// The library has the functions of objects/Controller/include/device for a controller that runs on
// this computer and commands a robot through openr::remote.  The controller is a shared library
// linked with it (kit/controller_library.h).
#pragma once

namespace openr_host {

struct ControllerRun {
  const char* address;       // of the robot's remote control: "HOST[:PORT]"
  int timeout_ms;            // how long to wait for an answer of the robot
  const char* folder;        // folder of the controller, for its *.MTN
  int (*controller_main)();  // calls main() of the controller
};

// Runs the controller until its loop ends, Ctrl-C is pressed, or the connection ends.  Prints
// errors and the achieved time step on standard error.  Returns the exit status.  If the controller
// waits in robot_step() at that moment, the process exits with this status instead.
using RunController = int(const ControllerRun& run);
inline constexpr char kRunControllerName[] = "openr_run_controller";

}  // namespace openr_host
