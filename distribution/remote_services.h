// RemoteServices: the OPENR:: functions about devices (joints, sensors, power) for objects in a
// worker.  Each call is a question to the master, because the master has the robots.
#pragma once

#include "distribution/master_link.h"
#include "runtime/core/robot_services.h"

namespace openr_host {

class RegionTable;

class RemoteServices : public RobotServices {
 public:
  // `regions` has the shared memory of the objects in this process.  Both arguments must outlive
  // this object.
  RemoteServices(MasterLink* master, const RegionTable* regions)
      : master_(master), regions_(regions) {}

  OPENR_ROBOT_CALLS(OPENR_OVERRIDE_CALL, OPENR_OVERRIDE_CALL)

  // Does not override the functions of RobotServices that only the runtime calls, because a worker
  // does not need them.  HashState() is not needed, because the master has the devices and hashes
  // their state.  TimeOffUs() and the functions for a robot that is off are not needed, because no
  // robot boots again in a worker (Robot::load_again is null).

 private:
  // Asks the master to call `kFunction` of the robot's services, and returns the result.
  template <auto kFunction, typename... Arguments>
  OStatus Ask(const Arguments&... arguments);

  MasterLink* const master_;
  const RegionTable* const regions_;
};

}  // namespace openr_host
