// ForwardingServices: passes each call of an OPENR:: function to other RobotServices in the same
// process.
//
// A derived class overrides the functions that it executes itself, and chooses the RobotServices
// for all other functions.
#pragma once

#include "runtime/core/robot_services.h"

namespace openr_host {

class ForwardingServices : public RobotServices {
 public:
#define OPENR_FORWARD(name, parameters, arguments, without_devices) \
  OStatus name parameters override { return ServicesFor(#name).name arguments; }
  OPENR_ROBOT_CALLS(OPENR_FORWARD, OPENR_FORWARD)
#undef OPENR_FORWARD

 private:
  // Returns the RobotServices that execute this call of the OPENR:: function with the name
  // `function`.
  virtual RobotServices& ServicesFor(const char* function) = 0;
};

}  // namespace openr_host
