// Schedule, which chooses among the orders of messages that the robot allows, and Gate, which holds
// messages back.
//
// Without a schedule the order is the canonical one: objects start in the order of OBJECT.CFG, and
// messages that are due at the same time are delivered by class (MessageClass), then by priority,
// then by number.  Schedule::Choose() can change the order of the starts.  It can also change the
// order of messages that have the same due time, class and priority, but not the order of the
// messages to one receiver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "runtime/base/rng.h"
#include "runtime/core/message.h"

namespace openr_host {

class Schedule {
 public:
  virtual ~Schedule() = default;

  enum class Question : uint8_t {
    kStart,  // the object that gets DoStart next
    kNext,   // the object that gets its message next, among the objects with a message due now
  };

  // Chooses one of the objects in `candidates` and returns its index.  `question` says what the
  // chosen object gets next: its DoStart, or its next message.  Index 0 is the choice of a run
  // without a schedule.  Called only with two or more candidates.
  virtual size_t Choose(Question question, const std::vector<ObjectId>& candidates) = 0;

  // Returns the time to add to the due time of `message`, which is being posted and is due
  // `delay_us` from now.  A schedule that delays one message must also delay the later messages of
  // the same sender to the same receiver, so that the later messages do not overtake it.
  virtual int64_t ExtraDelayUs(const Message& message, int64_t now_us, int64_t delay_us);

  // Returns whether the sender's call to post `message` shall fail, as on the robot when the queue
  // of the receiver is full.
  virtual bool Refuses(const Message& message);
};

// Decides for every message, just before its delivery, whether it may be delivered now.  Used by
// tests that need messages in a certain order.
class Gate {
 public:
  virtual ~Gate() = default;
  // Returns `message` if it may be delivered now.  Otherwise the gate keeps it, gives it back later
  // with System::Readmit(), and returns null.
  virtual OwnedMessage Admit(OwnedMessage message) = 0;
  // Calls `visit` for every message that the gate keeps.
  virtual void ForEach(const std::function<void(const Message&)>& visit) const = 0;
};

// A schedule that chooses at random, with a generator that depends only on `seed`.
class SeedSchedule : public Schedule {
 public:
  explicit SeedSchedule(uint64_t seed) : rng_(seed, "order") {}
  size_t Choose(Question question, const std::vector<ObjectId>& candidates) override;

 private:
  Rng rng_;
};

}  // namespace openr_host
