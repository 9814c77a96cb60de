// What decides where the robot leaves an order open, and what may get in the way.
//
// Without a schedule the order is the canonical one: objects start as OBJECT.CFG names
// them, messages due together go by number.  A schedule may only choose among orders
// the robot allows: per receiver messages stay in order, priorities hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/base/rng.h"
#include "runtime/core/message.h"

namespace openr_host {

class Schedule {
 public:
  virtual ~Schedule() = default;

  enum class Question : uint8_t {
    kStart,  // whose DoStart is next
    kNext,   // which object gets its message next, of those with one due at this instant
  };

  // Index of the candidate to take; 0 is the canonical one.  Asked only when there are
  // two or more.
  virtual size_t Choose(Question question, const std::vector<ObjectId>& candidates) = 0;

  // Called when `message` is posted, `delay_us` from now: us to add.  An implementation
  // that delays one message must delay those that follow from the same sender to the same
  // receiver at least as far.
  virtual int64_t ExtraDelayUs(const Message& message, int64_t now_us, int64_t delay_us);

  // Whether the receiver's queue turns `message` away, as a full one does.
  virtual bool Refuses(const Message& message);
};

// Stands at the door of every handler.
class Gate {
 public:
  virtual ~Gate() = default;
  // False: the message is kept by the gate, which gives it back with System::Readmit().
  virtual bool Admit(Message* message) = 0;
};

// A legal order drawn from a seed.
class SeedSchedule : public Schedule {
 public:
  explicit SeedSchedule(uint64_t seed) : rng_(seed, "order") {}
  size_t Choose(Question question, const std::vector<ObjectId>& candidates) override;

 private:
  Rng rng_;
};

}  // namespace openr_host
