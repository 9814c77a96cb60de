// Ends a frame of 8 ms for all robots of a world together.
//
// Each robot has frames of its own, as its object OVirtualRobotComm runs them.  But robots in one
// world push each other, so their bodies must move at the same time.  When the frame of the first
// robot ends, the bodies of all robots move.
#pragma once

#include <cstdint>
#include <vector>

namespace openr_host {

struct RobotParts;

class SharedFrame {
 public:
  // Adds a robot to the world.  `robot` must outlive the last call of End().
  void Add(RobotParts* robot) { robots_.push_back(robot); }

  // Ends the frame that ends at the virtual time `now_us`: the hands of people and the faults act,
  // and the bodies move for 8 ms under the present set points.  Each robot calls End() for each of
  // its frames; only the first call for a frame has an effect.
  void End(int64_t now_us);

 private:
  std::vector<RobotParts*> robots_;
  // Number of the newest frame that End() has ended, counted from the beginning of the run.
  int64_t ended_frame_ = -1;
};

}  // namespace openr_host
