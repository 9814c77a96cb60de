// What becomes of joints whose commander is gone: an object that ran in a process of its own and
// crashed.
//
// They keep their last set point for a while, then go slowly to the sleeping posture, in which
// nothing can fall.  A joint that another object commands meanwhile is left to it.  (A robot has no
// such thing: there a crash stops all objects.  The times are ours to choose.)
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

  // Object `commander` is gone since frame `frame`.
  void CommanderIsGone(ObjectId commander, int64_t frame) {
    gone_.push_back({commander, frame, {}});
  }
  // A new one is in its place: its joints are its own again.
  void CommanderIsBack(ObjectId commander) {
    std::erase_if(gone_, [commander](const Gone& gone) { return gone.commander == commander; });
  }

  // Set points of frame `frame`, after those of command vectors.
  void Apply(int64_t frame, Devices* devices);

  void HashState(Hasher* hasher) const;

 private:
  struct Gone {
    ObjectId commander;
    int64_t since;                     // frame
    std::vector<slongword> from_urad;  // set points at the beginning of the move; empty before
  };

  const RobotModel& model_;
  std::vector<Gone> gone_;
};

}  // namespace openr_host
