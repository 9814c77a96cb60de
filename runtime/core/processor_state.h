// ProcessorState: an object's use of the robot's processor, if handlers take time; see cpu.h.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class ProcessorState {
 public:
  struct Outgoing {
    OwnedMessage message;
    int64_t delay_us;
  };

  // Returns the virtual time at which the object, which has a message to handle, began to wait for
  // the processor; -1 if the object does not wait for the processor.
  int64_t starving_since_us() const { return starving_since_us_; }
  // Records that the object waits for the processor.  If it did not wait before, the wait begins at
  // `now_us`.
  void NoteStarving(int64_t now_us) {
    if (starving_since_us_ < 0) starving_since_us_ = now_us;
  }
  // Ends the wait for the processor.  Returns when the wait began (starving_since_us()).
  int64_t EndStarving() { return std::exchange(starving_since_us_, -1); }

  // Messages that the handler has posted.  They leave when the handler's processor time is over.
  const std::vector<Outgoing>& outbox() const { return outbox_; }
  void KeepOutgoing(OwnedMessage message, int64_t delay_us) {
    outbox_.push_back({std::move(message), delay_us});
  }
  std::vector<Outgoing> TakeOutbox() { return std::exchange(outbox_, {}); }
  // Moves the messages to object `id`, except replies, from the outbox to the end of `messages`.
  void MoveOutgoing(ObjectId id, std::vector<OwnedMessage>* messages) {
    for (Outgoing& outgoing : outbox_) {
      if (outgoing.message->target == id && !outgoing.message->is_reply)
        messages->push_back(std::move(outgoing.message));
    }
    std::erase_if(outbox_, [](const Outgoing& outgoing) { return outgoing.message == nullptr; });
  }

 private:
  int64_t starving_since_us_ = -1;
  std::vector<Outgoing> outbox_;
};

}  // namespace openr_host
