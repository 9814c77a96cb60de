#include "runtime/core/dispatcher.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/base/upper_registers.h"
#include "runtime/core/cpu.h"
#include "runtime/core/delivery_prefetch.h"
#include "runtime/core/image_object.h"
#include "runtime/core/object_manager.h"
#include "runtime/core/stack_report.h"
#include "runtime/core/system.h"

namespace openr_host {

thread_local constinit Current t_current;

Dispatcher::Dispatcher(System* system)
    : system_(system),
      free_deliveries_(static_cast<uint64_t>(system->options().free_deliveries)),
      crowded_at_(free_deliveries_) {
  ASSERT(system->options().free_deliveries >= 1, "free_deliveries={}",
         system->options().free_deliveries);
}

Dispatcher::~Dispatcher() = default;

void Dispatcher::AddProcessor() { cpus_.push_back(std::make_unique<Cpu>(system_)); }

uint64_t Dispatcher::Run(const Limits& limits) {
  ASSERT(running_ == nullptr, "a handler must not run the system it belongs to");
  limits_ = limits;
  run_began_at_ = delivered_;
  // `stop_at_` is the number of deliveries after which Loop() begins to call MayContinue().  It is
  // 0 if Limits::until is set, because MayContinue() must then call `until` before every message.
  stop_at_ =
      limits.until != nullptr ? 0 : delivered_ + std::min(limits.messages, UINT64_MAX - delivered_);
  if (system_->powered_off()) Stop();
  // Takes the fiber before t_current changes, so that t_current keeps its value if TakeIdleFiber()
  // throws an exception.
  Fiber* const fiber = TakeIdleFiber();
  const Current saved = t_current;
  t_current.system = system_;
  running_ = fiber;
  fiber->SwitchFrom(&caller_);
  running_ = nullptr;
  t_current = saved;
  if (failure_ != nullptr) std::rethrow_exception(std::exchange(failure_, nullptr));
  return delivered_ - run_began_at_;
}

// Takes a fiber (stack) out of idle_, or makes a new fiber if idle_ is empty.  If there is no
// memory for a new stack, ends the run as a crash of the current object, or throws an exception if
// no object is current.  So WaitFor() and Abandon() call this function before they change t_current
// or the state of the object.
Fiber* Dispatcher::TakeIdleFiber() {
  if (idle_.empty()) {
    // Reserves room for all fibers in idle_, so that push_back() takes no memory in functions that
    // could not handle a failure, such as Recycle().
    idle_.reserve(fibers_.size() + 1);
    fibers_.push_back(std::make_unique<Fiber>());
    fibers_.back()->Prepare(&FiberMain, this);
    return fibers_.back().get();
  }
  Fiber* const fiber = idle_.back();
  idle_.pop_back();
  return fiber;
}

// The function with which a fiber begins.  An exception cannot pass from one stack to another, so
// this function catches each exception that leaves Loop(), and Run() throws it.  An example is
// std::bad_alloc, if there is no memory to record a message.
void Dispatcher::FiberMain(void* dispatcher) {
  Dispatcher* const self = static_cast<Dispatcher*>(dispatcher);
  for (;;) {
    try {
      self->Loop();
    } catch (...) {
      self->failure_ = std::current_exception();
    }
    self->ToCaller();
  }
}

// Leaves the running fiber (a stack on which handlers run) and continues `fiber`.  Returns when
// another fiber continues the fiber that was left.
void Dispatcher::SwitchTo(Fiber* fiber) {
  Fiber* const from = running_;
  running_ = fiber;
  fiber->SwitchFrom(from);
  Recycle();
}

// Makes Run() return to its caller.  The running fiber (stack) stops in this function, which
// returns when a later Run() continues the fiber.
void Dispatcher::ToCaller() {
  Fiber* const from = running_;
  idle_.push_back(from);
  caller_.SwitchFrom(from);
  Recycle();
}

// Prepares the fiber (stack) of an abandoned handler for a new use.  Abandon() cannot do this
// itself, because Abandon() runs on that fiber.
void Dispatcher::Recycle() {
  if (abandoned_ == nullptr) return;
  abandoned_->Prepare(&FiberMain, this);
  idle_.push_back(abandoned_);
  abandoned_ = nullptr;
}

// Returns whether the limits of Run() allow one more message.
bool Dispatcher::MayContinue() const {
  return delivered_ - run_began_at_ < limits_.messages &&
         (limits_.until == nullptr || !(*limits_.until)());
}

// The functions from here to Loop() are inline, so that the compiler joins them into one function.
// This saves time, because every message passes through all these functions on its way from the
// queue to the handler.

[[gnu::always_inline]] inline void Dispatcher::FinishHandler(Object* object) {
  if (object->is_image()) [[unlikely]]
    FinishImage(object);
  t_current.object = nullptr;
  object->EndHandler();
  if (!object->delivery().is_busy()) object->ReturnHeld();
}

// Ends the measurements of a handler whose code is in an image: ends the watch for floating-point
// faults, reports these faults, and records how much stack the handler has used.
void Dispatcher::FinishImage(Object* object) {
  if (t_current.watch != nullptr) std::exchange(t_current.watch, nullptr)->End();
  auto* const image = static_cast<ImageObject*>(object);
  if (system_->options().measure_stacks) NoteStackUse(object, image->StackUsed());
  image->CheckNumbers(object->running()->selector);
  t_current.image_code = false;
}

// Calls the entry (function) of `object` for the message that the object is to handle
// (Object::running()).  An uncaught exception or an unknown selector becomes a finding.
[[gnu::always_inline]] inline void Dispatcher::CallEntry(Object* object) {
  Message* const message = object->running();
  try {
    // Calls the entry of a CodeObject (an object that is part of this program and not loaded from a
    // file) directly.  This saves the virtual call of Object::Dispatch(), which would read one more
    // cache line.
    if (CodeEntry* const entry = FindCodeEntry(*object, message->selector)) {
      entry->Handle(message->payload);
      return;
    }
    if (!object->Dispatch(message->selector, message->payload)) [[unlikely]]
      ReportSelector(message->selector);
  } catch (const std::exception& e) {
    t_current.image_code = false;
    ReportException(*object, fmt::format(": {}", e.what()));
  } catch (...) {
    ReportException(*object, "");
  }
}

// Calls the entry of `object` as CallEntry() does, and measures the handler: watches for
// floating-point faults if the object is an image, and measures the wall time if
// SystemOptions::wall_clock_ns is set.
void Dispatcher::RunMeasured(Object* object) {
  ArithmeticWatch watch;
  // Reads the time from `clock`, the wall clock of the host, before the image becomes the current
  // object.  While an image is the current object, `clock` would return the time of the robot.
  const auto clock = system_->options().wall_clock_ns;
  const int64_t begin_ns = clock == nullptr ? 0 : clock();
  const bool is_image = object->is_image();
  t_current = {system_, object, is_image, is_image ? &watch : nullptr};
  CallEntry(object);
  if (clock != nullptr) {
    const ApiScope scope;  // without this scope, clock() would return the time of the robot
    object->statistics().NoteHandler(clock() - begin_ns);
  }
  FinishHandler(object);
}

// Counts `message`, records it in the trace, and stores it in running() of `object` as the
// message that the object handles now.  From then on `object` owns the message.
[[gnu::always_inline]] inline void Dispatcher::BeginDelivery(Object* object, Message* message) {
  object->NoteTaken();
  if (++delivered_ >= crowded_at_) [[unlikely]]
    NoteManyDeliveries(object);
  // The object owns the message.  A local variable would be lost with the running stack if the
  // handler is abandoned.  The object gets the message before Deliver() is called, because
  // Deliver() may throw an exception.
  object->BeginHandler(message);
  system_->trace().Deliver(*message, system_->now_us());
  object->NoteDelivered();
  // The code of a handler was compiled for SSE.  It would run slowly if AVX code, such as the
  // string functions of the C library, has left bits in the upper halves of the vector registers
  // (upper_registers.h).
  ClearUpperRegisters();
}

// Returns `message` if `object`, its receiver, can handle it now.  Otherwise returns null, because
// the message was dropped, was delivered as a reply (which needs no new handler), or is kept for
// later.
OwnedMessage Dispatcher::Admit(Object* object, OwnedMessage message) {
  if (object->delivery().is_off()) {
    if (!message->is_reply) object->NoteTaken();
    return nullptr;
  }
  // Holds the message while the last handler of the receiver waits or still has the processor
  // (`is_in_handler`), and while the receiver is in its boot (IsTooEarly()).  A reply is never
  // held, because the handler that waits needs it.
  const bool is_in_handler =
      object->delivery().blocked() != nullptr || object->delivery().is_busy();
  if (!message->is_reply && (is_in_handler || system_->manager().IsTooEarly(*message))) {
    object->delivery().Hold(std::move(message));
    return nullptr;
  }
  // A gate (schedule.h), which a test has set, may keep the message and put it back into the queue
  // later.
  if (gate_ != nullptr) {
    message = gate_->Admit(std::move(message));
    if (message == nullptr) return nullptr;
  }
  if (message->is_reply) {
    DeliverReply(object, std::move(message));
    return nullptr;
  }
  // Gives the receiver the processor, or lets the message wait for the processor.  In a run whose
  // handlers take no time there are no processors, so the handler runs at once.
  if (!cpus_.empty() && !MayRun(object, *message)) {
    Cpu* const cpu = cpus_[static_cast<size_t>(object->robot)].get();
    cpu->Wait(object, std::move(message), system_->now_us());
    return nullptr;
  }
  are_deliveries_free_ = gate_ == nullptr && cpus_.empty() &&
                         system_->options().wall_clock_ns == nullptr &&
                         !system_->manager().HoldsMessages();
  return message;
}

// Delivers `message` to `object` when a plain call of the handler may not be enough.  Does nothing
// more if Admit() finds that the object cannot handle the message now.  Otherwise tells the object
// manager if a DoInit begins, and then runs and measures the handler (RunMeasured()).
[[gnu::noinline]] void Dispatcher::DeliverChecked(Object* object, OwnedMessage message) {
  message = Admit(object, std::move(message));
  if (message == nullptr) return;
  const bool begins = message->selector == oentryINIT;
  BeginDelivery(object, message.release());
  if (begins) system_->manager().NoteInitBegins(object->id);
  RunMeasured(object);
}

// Delivers `message` to its receiver.  The caller gives up the ownership of the message.
[[gnu::always_inline]] inline void Dispatcher::Deliver(Message* message) {
  PrefetchDeliveries(*message, system_->object_table());
  Object* const object = system_->object_table().GetKnown(message->target);
  const bool is_plain = object->is_plain() && are_deliveries_free_ && !message->is_reply;
  if (!is_plain) [[unlikely]]
    return DeliverChecked(object, OwnedMessage(message));
  BeginDelivery(object, message);
  // Does not set t_current.system, because Run() has set it already.
  t_current.object = object;
  t_current.image_code = false;
  t_current.watch = nullptr;
  CallEntry(object);
  t_current.object = nullptr;
  object->EndHandler();
  // Messages to the object may have been held while the handler waited.  In this case
  // Object::is_plain() is false, and FinishHandler() puts these messages back into the queue.
  if (!object->is_plain()) [[unlikely]]
    FinishHandler(object);
}

void Dispatcher::ReportSelector(uint32_t selector) {
  t_current.image_code = false;
  system_->AddFinding(Severity::kError,
                      fmt::format("selector is out of range: sel={}; the sender's table and this "
                                  "object's stub do not belong together",
                                  selector));
}

// Reports an exception that the handler of `object` has not caught.  `what` is a colon and the text
// of the exception, or "" if the exception has no text.
void Dispatcher::ReportException(const Object& object, const std::string& what) {
  t_current.image_code = false;
  const std::string entry = object.EntryName(object.running()->selector);
  system_->AddFinding(Severity::kError,
                      fmt::format("uncaught exception in {}{}; on the robot abort()", entry, what));
}

// Called for many messages at one instant of virtual time: for the message with the number
// SystemOptions::free_deliveries, and for each message after it.  The first call adds a finding.
// Each later call sets MessagePoster::crowding_delay_us() to 1, so that each message that is posted
// from then on takes 1 us.  The counting of messages begins anew when the clock moves by more than
// 1 us at once (AdvanceTo()).
void Dispatcher::NoteManyDeliveries(const Object* object) {
  if (delivered_ > crowded_at_) {
    system_->poster().set_crowding_delay_us(1);
    return;
  }
  system_->AddFindingAbout(object, Severity::kWarning,
                           fmt::format("{} messages without the clock moving: objects answer each "
                                       "other without waiting; from here each message takes 1 us",
                                       free_deliveries_));
}

void Dispatcher::Loop() {
  Recycle();
  for (;;) {
    if (delivered_ >= stop_at_ && !MayContinue()) {
      ToCaller();
      continue;
    }
    MessageQueue& queue = system_->queue();
    if (OwnedMessage message = queue.Pop(system_->poster().schedule())) {
      Deliver(message.release());
      continue;
    }
    // Moves the clock to the next message or other event, because no message is due now.
    const int64_t next_us = std::min(queue.NextTime(), NextInstant());
    if (next_us <= limits_.time_us && next_us != INT64_MAX) {
      AdvanceTo(next_us);
      DoDueWork();
      continue;
    }
    if (limits_.time_us != INT64_MAX) AdvanceTo(limits_.time_us);
    ToCaller();
  }
}

// Returns the time of the next event that is no message: the end of a handler's processor time, a
// time event, an input, or the end of a frame of a robot that is off.
//
// NextInstant() and DoDueWork() run only when no message is due.  So they are not inline: Loop(),
// through which every message passes, stays small.
[[gnu::noinline]] int64_t Dispatcher::NextInstant() const {
  int64_t end_us = std::min({system_->time_events().NextUs(), system_->inputs().NextUs(),
                             system_->robot_table().off_robots().NextUs()});
  for (const auto& cpu : cpus_) end_us = std::min(end_us, cpu->EndUs());
  return end_us;
}

// Handles the events for which NextInstant() returns a time and that are due now: ends of processor
// time, time events, inputs and frames of robots that are off.
[[gnu::noinline]] void Dispatcher::DoDueWork() {
  const int64_t now_us = system_->now_us();
  for (const auto& cpu : cpus_) {
    if (cpu->EndUs() == now_us) cpu->End(now_us);
  }
  system_->inputs().DoDue();
  system_->robot_table().off_robots().DoDue();
  system_->time_events().PostDue();
}

void Dispatcher::AdvanceTo(int64_t time_us) {
  // Begins to count the messages at one instant anew, but not if the clock moves by only 1 us.
  // Such a step may come from MessagePoster::crowding_delay_us(), which delays the messages of
  // objects that answer each other without waiting.  This delay must not end while the objects
  // still answer each other.
  if (time_us > system_->now_us() + 1) {
    crowded_at_ = delivered_ + free_deliveries_;
    system_->poster().set_crowding_delay_us(0);
  }
  system_->queue().Advance(time_us);
}

// Gives `object` the processor for `message` and returns true.  Returns false if the processor is
// not free, so that `message` must wait.
bool Dispatcher::MayRun(Object* object, const Message& message) {
  if (object->is_system()) return true;
  Cpu* const cpu = cpus_[static_cast<size_t>(object->robot)].get();
  if (!cpu->IsFreeFor(*object)) return false;
  cpu->Grant(object, system_->now_us());
  const int64_t cost_us = system_->options().cost->CostUs(*object, message.selector);
  if (cost_us > 0) cpu->Begin(object, message.selector, cost_us, system_->now_us());
  return true;
}

void Dispatcher::DeliverReply(Object* object, OwnedMessage message) {
  ++delivered_;
  ++crowded_at_;  // raises the limit for NoteManyDeliveries(), which counts no replies
  system_->trace().Deliver(*message, system_->now_us());
  const uint64_t box = message->reply_box;
  // The reply box may have been closed since `message` was posted: by CleanRBox(), or because the
  // reply came and `message` is the time-out.  Then no handler waits for `message`, so it is
  // dropped.
  if (!object->boxes().IsOpen(box)) return;
  object->boxes().Put(box, std::move(message));
  // If the handler does not wait for this reply, the reply stays in its box until the object asks
  // for it in a later call.  The messages that the object has ordered for the arrival of this reply
  // (reply events) are posted now.
  if (object->delivery().blocked() == nullptr || object->wait().box() != box) {
    system_->time_events().ReplyArrived(object->id, box);
    return;
  }
  Fiber* const waiting = object->delivery().blocked();
  object->delivery().set_blocked(nullptr);
  idle_.push_back(running_);  // makes this fiber idle: TakeIdleFiber() can continue its loop
  SwitchTo(waiting);          // continues WaitFor(), which makes `object` the current object again
}

OwnedMessage Dispatcher::WaitFor(uint64_t box) {
  Object* const object = t_current.object;
  ASSERT(object != nullptr && running_ != nullptr, "only a handler can wait");
  if (!object->boxes().HasReply(box)) {
    Fiber* const next = TakeIdleFiber();
    // Saves the current object, because Loop() must run without a current object.  While this
    // handler waits on its fiber, Loop() delivers messages on another fiber, until DeliverReply()
    // switches back to this fiber.  If `object` stayed current, Loop() could take a time event that
    // is due meanwhile for a message of this handler, and keep it in the outbox of `object`.
    const Current saved = t_current;
    t_current = {system_, nullptr};
    object->delivery().set_blocked(running_);
    object->wait().Begin(box, system_->now_us());
    SwitchTo(next);
    t_current = saved;
  }
  return object->boxes().Take(box);
}

void Dispatcher::Abandon() {
  ASSERT(running_ != nullptr && t_current.object != nullptr, "only a handler can be abandoned");
  // Ends the watch of the handler before a fiber is made, because a new fiber begins with the
  // present rounding mode and with the present mask bits for SIGFPE.
  if (t_current.watch != nullptr) t_current.watch->End();
  Fiber* const next = TakeIdleFiber();
  // If the object has called an entry of its own directly, self_reply points to a variable on the
  // stack that this function gives up.  So clears self_reply: otherwise later replies of the object
  // would be written to that variable.
  t_current.object->set_self_reply(nullptr);
  FinishHandler(t_current.object);
  // Does not prepare the running fiber (stack) for its next use here, because this code still runs
  // on it.  Recycle() does so after the switch to the next fiber.
  abandoned_ = running_;
  running_ = next;
  next->SwitchFrom(nullptr);
  __builtin_unreachable();
}

}  // namespace openr_host
