// Cpu: the processor of a robot, for runs in which handlers take time.
//
// Without a CostModel, handlers take no time.  With a CostModel, one handler at a time has the
// processor; a handler of higher priority interrupts it, a handler of equal or lower priority
// waits.  The code of a handler runs at the moment when the handler gets the processor.  From then
// on the object of the handler is busy until the cost of the handler has passed.  Only then the
// messages leave that the handler has posted, and only then the object can handle its next message.
// Objects that are parts of the robot (Object::is_system()) take no processor time.
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class Hasher;
class Object;
class System;

// A model that says how much processor time each handler takes.
class CostModel {
 public:
  virtual ~CostModel() = default;
  // Returns the processor time of one call of entry `selector`, >= 0.  Called once per delivery and
  // in order of delivery, so a model may draw random numbers from its own generator.
  virtual int64_t CostUs(const Object& object, uint32_t selector) = 0;
  // Returns the virtual time in us that a frame (the step in which the robot's sensors and joints
  // work) takes: 8 ms on a robot.  A model may set another length.
  virtual int64_t FrameUs() const;
  // Adds to the state hash all state of this model that can change what handlers cost later in the
  // run.
  virtual void HashState(Hasher*) const {}
};

class Cpu {
 public:
  explicit Cpu(System* system) : system_(system) {}
  Cpu(const Cpu&) = delete;
  Cpu& operator=(const Cpu&) = delete;

  // Returns whether `object` may run a handler now: whether the processor is free, or runs a
  // handler of lower priority.  REQUIRES: `object` belongs to this robot.
  bool IsFreeFor(const Object& object) const;

  // The longest normal wait of an object for the processor; a longer wait becomes a finding.  The
  // value is our choice.
  static constexpr int64_t kStarvedUs = 1'000'000;

  // The longest time that a handler normally takes.  A longer handler becomes a finding, because it
  // takes more than the time between two sensor vectors (field-notes.md, 1.12).
  static constexpr int64_t kLongHandlerUs = 32'000;

  // Keeps `message`, whose receiver `object` must wait for the processor, until a handler ends and
  // the processor may be free.  Records that the wait of the object began at `now_us`.
  void Wait(Object* object, OwnedMessage message, int64_t now_us);

  // Returns the messages whose receiver waits for the processor, oldest first.
  const std::vector<OwnedMessage>& waiting() const { return waiting_; }

  // Removes the messages to object `id` that wait for the processor, and returns them, oldest
  // first.
  std::vector<OwnedMessage> TakeMessagesTo(ObjectId id);

  // Ends the wait of `object` for the processor, which the object gets now.  Adds a finding if the
  // object has waited longer than kStarvedUs.
  void Grant(Object* object, int64_t now_us);

  // Gives the processor to a handler of entry `selector` that takes `cost_us`.  REQUIRES: cost_us >
  // 0 and IsFreeFor(*object).
  void Begin(Object* object, uint32_t selector, int64_t cost_us, int64_t now_us);

  // Returns the time at which the running handler ends if no other handler interrupts it; INT64_MAX
  // if no handler runs.
  int64_t EndUs() const;

  // Ends the handler that has the processor, because its time is over: sends the messages that it
  // posted, and lets other handlers run.  If a posted request is refused, its sender stops waiting
  // for the reply, as at a time-out.  REQUIRES: EndUs() == now_us.
  void End(int64_t now_us);

  void HashState(Hasher* hasher) const;

 private:
  struct Job {
    Object* object;
    int64_t left_us;   // processor time that the handler still needed at `since_us`
    int64_t since_us;  // virtual time when the handler last got the processor
  };

  System* const system_;
  std::vector<Job> jobs_;  // the last job runs; the jobs before it were interrupted
  // The messages whose receiver waits for the processor, oldest first.
  std::vector<OwnedMessage> waiting_;
};

// Posts the messages in the outbox of `object`, which is not busy any more.  If a request is
// refused, ends the wait of its sender for the reply, as at a time-out.
void PostOutbox(Object* object);

}  // namespace openr_host
