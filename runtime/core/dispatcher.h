// Dispatcher: takes messages from the queue and calls the handlers of their receivers.  It uses one
// thread and runs one handler at a time.
//
// A handler that waits for a reply keeps its stack, a fiber (fiber.h).  The dispatcher then goes on
// with other messages on another fiber.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/fiber.h"
#include "runtime/core/message.h"

namespace openr_host {

class Object;
class System;

class Dispatcher {
 public:
  explicit Dispatcher(System* system);
  ~Dispatcher();

  struct Limits {
    int64_t time_us = INT64_MAX;     // no message that is due later is delivered
    uint64_t messages = UINT64_MAX;  // the largest number of messages to deliver
    // If not null, no more messages are delivered once this function returns true.
    const std::function<bool()>* until = nullptr;
  };

  // Delivers messages until a limit is reached or no message is left, and returns the number of
  // delivered messages.  If the time was the limit that was reached, leaves the clock at
  // limits.time_us.  REQUIRES: not called in a handler.
  uint64_t Run(const Limits& limits);

  // Makes Run() return when the running handler has ended.  Called when all robots are off.
  void Stop() { limits_.messages = 0; }

  // Suspends the running handler until a reply arrives in the object's reply box `box`, and returns
  // the reply.  REQUIRES: called in a handler.
  OwnedMessage WaitFor(uint64_t box);

  // Does the work of System::AbandonHandler(): ends the running handler without returning to it.
  [[noreturn]] void Abandon();

  // Returns the time to add to a message posted now: 1 us if more messages were delivered at this
  // instant than SystemOptions::free_deliveries, otherwise 0.
  int64_t creep_us() const { return creep_us_; }

 private:
  static void FiberMain(void* dispatcher);
  void Loop();
  bool MayContinue() const;
  void ToCaller();
  void AdvanceTo(int64_t time_us);
  void Deliver(Message* message);
  OwnedMessage Admit(Object* object, OwnedMessage message);
  void NoteManyDeliveries(const Object* object);
  void ReportSelector(uint32_t selector);
  void ReportException(const Object& object, const std::string& what);
  bool MayRun(Object* object, const Message& message);
  void DeliverReply(Object* object, OwnedMessage message);
  void RunHandler(Object* object, Message* message);
  void RunMeasured(Object* object);
  void CallEntry(Object* object);
  void FinishHandler(Object* object);
  void FinishImage(Object* object);
  Fiber* TakeFiber();
  void SwitchTo(Fiber* fiber);
  void Recycle();

  System* const system_;
  // The stack of the thread that has called Run().
  MainFiber caller_;
  std::vector<std::unique_ptr<Fiber>> fibers_;
  // Fibers that can be used next; each is stopped in Loop(), the loop that delivers messages, or
  // prepared to enter it.
  std::vector<Fiber*> idle_;
  Fiber* running_ = nullptr;
  Fiber* abandoned_ = nullptr;  // the fiber that Abandon() left; the next fiber puts it into idle_
  Limits limits_;
  uint64_t delivered_ = 0;  // messages delivered in the current Run()
  const int64_t free_deliveries_;
  int64_t deliveries_at_instant_ = 0;
  int64_t creep_us_ = 0;
};

}  // namespace openr_host
