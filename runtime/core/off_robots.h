// OffRobots: the robots of a System that are switched off and will boot again by themselves.
//
// OPENR::Shutdown() with a boot timer switches a robot off until the timer has run down.  Meanwhile
// none of its objects runs, but the body still obeys physics: a standing robot sinks.
#pragma once

#include <cstdint>
#include <map>

namespace openr_host {

class Hasher;
class System;

class OffRobots {
 public:
  // `system` must outlive this object.
  explicit OffRobots(System* system) : system_(system) {}

  // Adds robot number `robot`, which has just been switched off and boots at `boot_us`.
  void Add(int robot, int64_t boot_us);
  // Removes robot number `robot` from the robots that wait for their boot.  Returns false if the
  // robot was not one of them.
  bool Remove(int robot);

  bool empty() const { return robots_.empty(); }
  bool Contains(int robot) const { return robots_.contains(robot); }
  // Returns the virtual time at which robot number `robot` boots.  REQUIRES: Contains(robot).
  int64_t BootUs(int robot) const;

  // Returns the virtual time at which the next frame of a robot that is off ends; INT64_MAX if
  // there is none.  Each robot that is off has frames of its own, at whose ends its body moves
  // (DoDue()).
  int64_t NextUs() const;
  // Moves the body of each robot that is off and whose frame ends now, and posts the robot's boot
  // if it is due.  The object manager may execute a posted boot later.  So a robot stays in robots_
  // until it really boots: then RobotTable::LoadAgain() calls Remove().
  void DoDue();

  void HashState(Hasher* hasher) const;

 private:
  struct Times {
    // End of the frame in which the robot, which is off, is now; INT64_MAX once the boot of the
    // robot is posted.
    int64_t frame_us;
    int64_t boot_us;  // the robot boots at the end of the first frame that ends at boot_us or later
  };

  System* const system_;
  std::map<int, Times> robots_;  // the key is the number of the robot
};

}  // namespace openr_host
