// Moves joints to a safe posture after the object that commanded them has crashed in a process of
// its own.
//
// The joints keep their last set point for a while.  Then they go slowly to the sleeping posture,
// in which the robot cannot fall.  A joint that another object commands meanwhile is left to that
// object.  The real robot has no such function, because a crash stops all its objects.  The times
// are our choice.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "runtime/core/message.h"
#include "virtualrobot/devices/devices.h"

namespace openr_host {

class Hasher;

class SafePosture {
 public:
  static constexpr int64_t kHoldFrames = 250;  // time without movement after the crash: 2 s
  static constexpr int64_t kMoveFrames = 500;  // duration of the movement to the safe posture: 4 s

  explicit SafePosture(const RobotModel& model) : model_(model) {}

  // Starts the movement of the joints of object `commander`, which has crashed in frame `frame`, to
  // a safe posture.
  void OnCommanderLost(ObjectId commander, int64_t frame) {
    lost_commanders_.push_back({commander, frame, {}});
  }
  // Ends the movement of the joints of object `commander` to a safe posture, because the object
  // runs again.
  void OnCommanderBack(ObjectId commander) {
    std::erase_if(lost_commanders_,
                  [commander](const LostCommander& lost) { return lost.commander == commander; });
  }

  // Ends all movements to a safe posture, because the robot is switched off.
  void SwitchOff() { lost_commanders_.clear(); }

  // Holds the joints that a crashed object has commanded, or moves them towards the safe posture:
  // sets their set points of frame `frame`.  Called after the command vectors have set theirs,
  // because a joint that another object commands is left to that object.
  void Apply(int64_t frame, Devices* devices);

  void HashState(Hasher* hasher) const;

 private:
  struct LostCommander {
    ObjectId commander;
    int64_t since;  // frame in which the object crashed
    // Set points of all joints when the movement to the safe posture starts; empty before it
    // starts.
    std::vector<slongword> from_urad;
  };

  const RobotModel& model_;
  std::vector<LostCommander> lost_commanders_;
};

}  // namespace openr_host
