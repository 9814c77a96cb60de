// When the vector at the head of a queue may begin: at once, or with the other parts of
// its synchronisation key.
#pragma once

#include <OPENR/ODataFormats.h>
#include <fmt/format.h>

#include <string>
#include <vector>

#include "virtualrobot/sync_keys.h"

namespace openr_host {

class VectorTurn {
 public:
  // `key` is that of the vector at the head.  Once a frame, for all queues of a robot before
  // MayStart() of any.
  void Announce(OVRSyncKey key, SyncKeys* keys) {
    if (announced_) return;
    keys->Arrive(key);
    announced_ = true;
  }

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

  // The vector has begun; the next one is at the head.
  void Next() { *this = {}; }

 private:
  static constexpr int kLongFrames = 1250;  // 10 s; chosen

  bool announced_ = false;
  int frames_waited_ = 0;
};

}  // namespace openr_host
