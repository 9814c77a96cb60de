// Moves joints to a safe posture after the object that commanded them has crashed in a process of
// its own.
//
// The joints keep their last set point for a while.  Then they go slowly to the sleeping posture,
// in which the robot cannot fall.  A joint that another object commands meanwhile is left to that
// object.  The robot has no such function, because there a crash stops all objects; the times are
// our choice.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "runtime/core/message.h"
#include "virtualrobot/devices.h"

namespace openr_host {

class Hasher;

class SafePosture {
 public:
  static constexpr int64_t kHoldFrames = 250;  // 2 s
  static constexpr int64_t kMoveFrames = 500;  // 4 s

  explicit SafePosture(const RobotModel& model) : model_(model) {}

  // Tells that object `commander` has crashed in frame `frame`.
  void CommanderIsGone(ObjectId commander, int64_t frame) {
    gone_.push_back({commander, frame, {}});
  }
  // Tells that the object runs again.  Its joints are no longer moved from here.
  void CommanderIsBack(ObjectId commander) {
    std::erase_if(gone_, [commander](const Gone& gone) { return gone.commander == commander; });
  }

  // Sets the set points of frame `frame`.  Called after those of command vectors are set.
  void Apply(int64_t frame, Devices* devices);

  void HashState(Hasher* hasher) const;

 private:
  struct Gone {
    ObjectId commander;
    int64_t since;                     // frame of the crash
    std::vector<slongword> from_urad;  // set points when the move begins; empty before
  };

  const RobotModel& model_;
  std::vector<Gone> gone_;
};

}  // namespace openr_host
