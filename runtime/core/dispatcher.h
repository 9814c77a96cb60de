// Dispatcher: takes messages from the queue and calls the handlers of their receivers.  It uses one
// thread and runs one handler at a time.
//
// A handler that waits for a reply keeps its stack, a fiber (fiber.h).  The dispatcher then goes on
// with other messages on another fiber.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/fiber.h"
#include "runtime/core/message.h"

namespace openr_host {

class Cpu;
class Gate;
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
  // delivered messages.  If limits.time_us is set and no other limit was reached before, the clock
  // is at limits.time_us afterwards.  Throws the exceptions of code that is no handler, such as
  // limits.until.  REQUIRES: not called in a handler.
  uint64_t Run(const Limits& limits);

  // Makes Run(), the loop that delivers messages, return when the running handler has ended.
  // Called when all robots are off.
  void Stop() {
    limits_.messages = 0;
    stop_at_ = 0;
  }

  // Suspends the running handler until a reply arrives in the object's reply box `box`, and returns
  // the reply.  REQUIRES: called in a handler.
  OwnedMessage WaitFor(uint64_t box);

  // Does the work of System::AbandonHandler(): ends the running handler without returning to it.
  [[noreturn]] void Abandon();

  // Adds a processor (cpu.h) for one more robot: the first call for robot 0, the second for robot
  // 1, and so on.  Called only if there is a cost model.
  void AddProcessor();
  // Returns the processors of all robots, by index of the robot.  Without a cost model the result
  // is empty.
  const std::vector<std::unique_ptr<Cpu>>& cpus() const { return cpus_; }

  // Sets the gate (schedule.h), which decides for each message whether it may be delivered now.
  // Gates are for tests and tools that explore orders of messages.  The dispatcher does not own the
  // gate, so the gate must exist as long as messages are delivered.  If `gate` is null, there is no
  // gate.
  void set_gate(Gate* gate) {
    gate_ = gate;
    CheckDeliveries();
  }
  const Gate* gate() const { return gate_; }
  // Makes the dispatcher ask Admit() for every message whether the receiver can handle the message
  // now.  Called when messages may have to be held back from now on: a gate was set, a robot was
  // added, which may have a processor (cpu.h), or objects begin to boot.  The dispatcher stops
  // asking when there is no gate and no processor, all objects have booted, and the time of
  // handlers is not measured (SystemOptions::wall_clock_ns).
  void CheckDeliveries() { are_deliveries_free_ = false; }

 private:
  static void FiberMain(void* dispatcher);
  void Loop();
  bool MayContinue() const;
  void ToCaller();
  void AdvanceTo(int64_t time_us);
  int64_t NextInstant() const;
  void DoDueWork();
  void Deliver(Message* message);
  void DeliverChecked(Object* object, OwnedMessage message);
  OwnedMessage Admit(Object* object, OwnedMessage message);
  void BeginDelivery(Object* object, Message* message);
  void NoteManyDeliveries(const Object* object);
  void ReportSelector(uint32_t selector);
  void ReportException(const Object& object, const std::string& what);
  bool MayRun(Object* object, const Message& message);
  void DeliverReply(Object* object, OwnedMessage message);
  void RunMeasured(Object* object);
  void CallEntry(Object* object);
  void FinishHandler(Object* object);
  void FinishImage(Object* object);
  Fiber* TakeIdleFiber();
  void SwitchTo(Fiber* fiber);
  void Recycle();

  System* const system_;
  bool are_deliveries_free_ = false;  // if false, Admit() is called for every message
  Gate* gate_ = nullptr;
  // The fiber for the stack of the thread that has called Run().
  MainFiber caller_;
  std::vector<std::unique_ptr<Fiber>> fibers_;
  // Fibers that can be used next; each is stopped in Loop(), the loop that delivers messages, or
  // prepared to enter it.
  std::vector<Fiber*> idle_;
  Fiber* running_ = nullptr;
  Fiber* abandoned_ = nullptr;  // the fiber that Abandon() left; the next fiber puts it into idle_
  Limits limits_;
  uint64_t delivered_ = 0;     // messages delivered in all calls of Run()
  uint64_t run_began_at_ = 0;  // value of delivered_ when the current Run() began
  // The value of delivered_ (the number of all delivered messages) from which on Loop() calls
  // MayContinue() before each message, to test the limits of Run().
  uint64_t stop_at_ = 0;
  const uint64_t free_deliveries_;
  // NoteManyDeliveries() is called for each message as soon as delivered_, the number of all
  // delivered messages, has this value.
  uint64_t crowded_at_;
  std::vector<std::unique_ptr<Cpu>> cpus_;  // by index of the robot; empty without a cost model
  std::exception_ptr failure_;  // an exception that has left Loop(); Run() throws it to its caller
};

}  // namespace openr_host
