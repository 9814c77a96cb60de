// RobotServices: the interface between the OPENR:: functions, which objects call, and the simulated
// robot.
//
// Every function of the table OPENR_ROBOT_CALLS has the meaning and the results of the function of
// the same name in OPENRAPI.h.  The base class is a robot without devices: its functions return
// oNOT_SUPPORTED, or the error for a primitive or key that does not exist.  The functions are
// called in handlers of objects, and memory that they allocate comes from the host's heap.
#pragma once

#include <OPENR/OPENRAPI.h>

#include <cstdint>
#include <optional>

#include "runtime/core/robot_calls.h"

// Declares the function of one row of OPENR_ROBOT_CALLS in a class derived from RobotServices.
// OPENR_ROBOT_CALLS(OPENR_OVERRIDE_CALL, OPENR_OVERRIDE_CALL) in the class declares the functions
// of all rows.
#define OPENR_OVERRIDE_CALL(name, parameters, arguments, without_devices) \
  OStatus name parameters override;

namespace openr_host {

class Hasher;

class RobotServices {
 public:
  virtual ~RobotServices() = default;

  // ---- Functions that do the work of the OPENR:: functions in the table of robot_calls.h, such as
  // GetVolumeSwitch()

#define OPENR_DECLARE_CALL(name, parameters, arguments, without_devices) \
  virtual OStatus name parameters;
  OPENR_ROBOT_CALLS(OPENR_DECLARE_CALL, OPENR_DECLARE_CALL)
#undef OPENR_DECLARE_CALL

  // ---- Functions that the runtime calls, and that objects cannot call

  // Returns the virtual time in us for which the robot stays off after Shutdown(), until its boot
  // timer boots it again; nullopt if only a person can boot the robot again.
  virtual std::optional<int64_t> TimeOffUs() const { return {}; }
  // Switches the devices off, and sets all their state and settings as at a boot.  Called after the
  // shutdown of a robot that will boot again.
  virtual void SwitchOff() {}
  // Moves the body for one frame while the robot is off.  Called at the end of the frame.
  virtual void RunFrameWhileOff() {}

  // Sets the state of all random generators of the robot as for a new robot with this seed.  Called
  // before System::Boot().
  virtual void Reseed(uint64_t) {}

  // Adds to the state hash all state of the robot that can change what the functions of
  // RobotServices do or return later.
  virtual void HashState(Hasher* hasher) const;
};

}  // namespace openr_host
