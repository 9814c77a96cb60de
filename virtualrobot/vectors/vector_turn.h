// VectorTurn: decides when the vector at the front of a queue may start: at once, or together with
// the vectors that carry the other parts of its synchronisation key.
#pragma once

#include <OPENR/ODataFormats.h>
#include <fmt/format.h>

#include <string>
#include <vector>

#include "virtualrobot/vectors/sync_keys.h"

namespace openr_host {

class VectorTurn {
 public:
  // Reports to `keys` that the vector at the front of the queue, which carries `key`, waits to
  // start.  Further calls for the same vector change nothing.  Called in each frame of 8 ms for all
  // queues of a robot, before MayStart() of any of them.
  void Announce(OVRSyncKey key, SyncKeys* keys) {
    if (announced_) return;
    keys->Arrive(key);
    announced_ = true;
  }

  // Returns whether the vector at the front of the queue may start in this frame.  Adds a text to
  // `problems` when the vector has waited for 10 s.
  bool MayStart(OVRSyncKey key, const SyncKeys& keys, std::vector<std::string>* problems) {
    if (keys.MayStart(key)) return true;
    if (++frames_waited_ == kLongFrames) {
      problems->push_back(fmt::format(
          "a vector has waited 10 s for the other parts of its synchronisation key: {}; send "
          "them, or CancelSyncKey()",
          keys.Progress(key)));
    }
    return false;
  }

  bool announced() const { return announced_; }

  // Called when the vector at the front of the queue has started.  Forgets what was recorded about
  // this vector, because the next vector is at the front now.
  void Next() { *this = {}; }

 private:
  static constexpr int kLongFrames = 1250;  // 10 s; a vector that waits so long is reported

  bool announced_ = false;
  int frames_waited_ = 0;
};

}  // namespace openr_host
