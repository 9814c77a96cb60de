// ReplyBoxes: the numbered boxes in which an object receives replies; see requests.h.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/message.h"

namespace openr_host {

class ReplyBoxes {
 public:
  uint64_t last() const { return last_; }  // the number of the newest box
  void set_last(uint64_t box) { last_ = box; }

  // Opens a box, in which a reply may arrive from now on.  REQUIRES: !IsOpen(box).
  void Open(uint64_t box) {
    const bool is_new = open_.insert(box).second;
    ASSERT(box != 0 && is_new, "box {} is opened again", box);
    last_ = std::max(last_, box);
  }
  // Opens a box whose number does not follow the numbers of the other boxes.  So last() does not
  // change.
  void OpenApart(uint64_t box) { open_.insert(box); }
  bool IsOpen(uint64_t box) const { return open_.contains(box); }
  // Closes a box and drops its reply.  Returns true if the object has ordered reply events for the
  // box.  The caller must then remove these events from TimeEvents, where they may still wait.
  bool Close(uint64_t box) {
    open_.erase(box);
    arrived_.erase(box);
    return with_event_.erase(box) > 0;
  }
  // Records that the object has ordered a reply event for the box (SetReplyEvent()).
  void NoteEvent(uint64_t box) { with_event_.insert(box); }

  // Puts a reply into its box.  REQUIRES: IsOpen(box).
  void Put(uint64_t box, OwnedMessage reply) {
    ASSERT(IsOpen(box), "box {} is not open", box);
    arrived_[box] = std::move(reply);
  }
  // Returns whether the box has a reply that no handler has received yet.
  bool HasReply(uint64_t box) const { return arrived_.contains(box); }
  // Takes the reply out of its box, which stays open.  REQUIRES: HasReply(box).
  OwnedMessage Take(uint64_t box) {
    const auto found = arrived_.find(box);
    ASSERT(found != arrived_.end(), "woken without a reply to box {}", box);
    OwnedMessage reply = std::move(found->second);
    arrived_.erase(found);
    return reply;
  }

 private:
  uint64_t last_ = 0;
  std::set<uint64_t> open_;
  std::map<uint64_t, OwnedMessage> arrived_;
  std::set<uint64_t> with_event_;
};

}  // namespace openr_host
