// The processor of a robot: handlers that take time.
//
// Only with a CostModel; otherwise handlers take none.  One handler at a time has the
// processor; one of higher priority takes it away, one of equal priority waits.  A handler
// that costs time runs when it gets the processor, and what it posts leaves when its
// time is over; until then its object hears nothing.  Objects of the system are not
// bound to the processor.
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class Hasher;
class Object;
class System;

class CostModel {
 public:
  virtual ~CostModel() = default;
  // Processor time of one call of entry `selector`, >= 0.  Called once per delivery, in
  // order, so it may draw from a generator of its own.
  virtual int64_t CostUs(const Object& object, uint32_t selector) = 0;
  // How long a frame of the robot's devices lasts by this clock.
  virtual int64_t FrameUs() const;
  // What decides future costs.
  virtual void HashState(Hasher*) const {}
};

class Cpu {
 public:
  explicit Cpu(System* system) : system_(system) {}
  Cpu(const Cpu&) = delete;
  Cpu& operator=(const Cpu&) = delete;

  // Whether `object`, of the robot this belongs to, may run a handler now.
  bool IsFreeFor(const Object& object) const;

  // An object that has waited longer for the processor is reported.
  static constexpr int64_t kStarvedUs = 1'000'000;

  // So is a handler that takes longer: sensor vectors come as often (field-notes.md, 1.12).
  static constexpr int64_t kLongHandlerUs = 32'000;

  // Keeps `message`, for `object`, until the processor is free.
  void Wait(Object* object, Message* message, int64_t now_us);

  // What it keeps for an object that is replaced, the oldest first; the caller's from now on.
  std::vector<Message*> TakeMessagesTo(ObjectId id);

  // `object` gets the processor for a handler, whatever it costs.
  void Grant(Object* object, int64_t now_us);

  // The handler of entry `selector` takes `cost_us` > 0.
  void Begin(Object* object, uint32_t selector, int64_t cost_us, int64_t now_us);

  // When the running handler ends if nothing comes between; INT64_MAX when none runs.
  int64_t EndUs() const;

  // The running handler's time is over: sends what it posted, lets the others go on.
  // REQUIRES: EndUs() == now_us.
  void End(int64_t now_us);

  void HashState(Hasher* hasher) const;

 private:
  struct Job {
    Object* object;
    int64_t left_us;   // while it does not run
    int64_t since_us;  // when it got the processor last
  };

  System* const system_;
  std::vector<Job> jobs_;  // the last one runs, the others were interrupted
  std::vector<Message*> waiting_;
};

}  // namespace openr_host
