// System: the clock, the message queue, the table of objects and everything that they share.
//
// A System is one deterministic run.  One process may have several Systems, each used from one
// thread.  The simulated robots and the network stack (IPStack) are objects of the System too.
//
//   System system({.seed = 1});
//   const int dog = system.AddRobot("ERS-210", stick);
//   AddVirtualRobot(&system, dog, ...);  // virtualrobot/
//   LoadStick(&system, dog);             // load_stick.h: objects and connections
//   system.Boot();
//   system.RunFor(30'000'000);
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/core/connection.h"
#include "runtime/core/console_input.h"
#include "runtime/core/cpu.h"
#include "runtime/core/current.h"
#include "runtime/core/findings.h"
#include "runtime/core/host_addresses.h"
#include "runtime/core/inputs.h"
#include "runtime/core/message.h"
#include "runtime/core/message_poster.h"
#include "runtime/core/object.h"
#include "runtime/core/object_table.h"
#include "runtime/core/region_shares.h"
#include "runtime/core/region_table.h"
#include "runtime/core/requests.h"
#include "runtime/core/robot.h"
#include "runtime/core/robot_table.h"
#include "runtime/core/run_end.h"
#include "runtime/core/schedule.h"
#include "runtime/core/system_calls.h"
#include "runtime/core/system_options.h"
#include "runtime/core/time_events.h"
#include "runtime/core/trace.h"

namespace openr_host {

class CodeObject;
class Dispatcher;
class GuardPages;
class MemoryStick;
class ObjectManager;
class RunFolder;

class System {
 public:
  explicit System(SystemOptions options = {});
  ~System();
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  // ---- Building a System, before Boot() ----

  // Adds a robot of the model `design` and returns its index.  `stick` is null if the robot has no
  // stick.
  int AddRobot(const std::string& design, std::shared_ptr<MemoryStick> stick);
  const Robot& robot(int index) const { return robot_table_.Get(index); }
  Robot& robot(int index) { return robot_table_.Get(index); }
  int robot_count() const { return robot_table_.count(); }

  // Makes an object of class T, a CodeObject, with the arguments given.  The constructor of T runs
  // with the new object as the current object (current.h).
  template <typename T, typename... Args>
  T* AddObject(int robot, const std::string& name, Args&&... args);

  // Returns the temporary folder for the copies of images; each object is loaded from a copy of its
  // own (run_folder.h).  The folder exists as long as the System.
  RunFolder* run_folder();

  // Adds a connection between two services, which the next boot makes.  REQUIRES: before Boot(), or
  // in Robot::load_again.
  void Connect(Connection connection);
  const std::vector<Connection>& connections() const { return robot_table_.connections(); }

  // Sets the state of all random generators to that of a System with this seed.  Does not change
  // the order of messages, which SystemOptions::seed or set_schedule() has decided before.
  // REQUIRES: before Boot().
  void Reseed(uint64_t seed);

  // Posts the message that begins the boot: DoInit of all objects, then their connections, then
  // DoStart of all objects.
  void Boot();

  // Posts a message whose handler calls `task`.  The message has the lowest priority, so `task` is
  // called as soon as no message of an object is due.
  void PostTask(std::function<void()> task);

  // Posts the shutdown of one robot: DoStop of its objects, then DoDestroy, then the robot is off.
  void Shutdown(int robot, const RunEnd& why = {});
  void Shutdown(const RunEnd& why = {});  // shuts down all robots
  bool booted() const;                    // whether the DoStart of every object is over
  // Returns whether all robots are off for good.
  bool powered_off() const { return robot_table_.are_all_off(); }
  // Switches one robot off at once, as OPENR::Fatal() does.  Messages to its objects are dropped
  // from now on.
  void PowerOff(int robot, const RunEnd& why = {});
  // Returns why the run has ended; see RobotTable::end().
  const std::optional<RunEnd>& end() const { return robot_table_.end(); }

  // ---- Running a System ----

  int64_t now_us() const { return poster_.queue().now_us(); }

  // Moves the clock to the due time of the next message and delivers the message.  Returns false if
  // there is no message.
  bool Step();

  // Delivers the next message if it is due by `time_us`; otherwise sets the clock to `time_us`.
  void RunOne(int64_t time_us);

  // Delivers `count` messages, or all messages if there are fewer.
  void RunMessages(uint64_t count);

  // Delivers all messages that are due up to `time_us` and sets the clock to `time_us`.  Stops
  // early when all robots are off.  REQUIRES: time_us >= now_us().
  void RunUntil(int64_t time_us);
  void RunFor(int64_t duration_us) { RunUntil(now_us() + duration_us); }

  // Runs until `predicate`, which is called after every message, returns true.  Returns false if
  // `predicate` has not returned true after `budget_us` of virtual time.  REQUIRES: budget_us >= 0.
  bool RunUntil(const std::function<bool()>& predicate, int64_t budget_us);

  // ---- Messages ----

  // Returns a message with an empty payload, to be filled and posted.  Its sender is the current
  // object, or the System if there is no current object.
  [[gnu::always_inline]] OwnedMessage NewMessage(ObjectId target, uint32_t selector) {
    const Object* const sender = t_current.object;
    const Message* const cause = sender == nullptr ? nullptr : sender->running();
    OwnedMessage message = poster_.queue().Allocate(
        sender == nullptr ? kNoObject : sender->id, cause == nullptr ? 0 : cause->number,
        sender == nullptr ? MessageClass::kObject : sender->post_class());
    message->target = target;
    message->selector = selector;
    return message;
  }

  // Queues a message that NewMessage() has made, due `delay_us` from now.  Returns an sError:
  // sSUCCESS, sINVALIDOID, or sFULLMSGQENTRY if the receiver's queue is full (only with
  // SystemOptions::strict) or if the schedule (schedule.h) makes the post fail.
  int32_t Post(OwnedMessage&& message, int64_t delay_us = 0) {
    host_addresses_.Check(*message);
    return calls_->Post(std::move(message), delay_us);
  }
  // Posts a notification or a ready as Post() does, but without the search for addresses of the
  // host in the message (HostAddresses::Check()).  SubjectState::Send() has already searched a
  // notification, and a program cannot put bytes into a ready.  This function is inline, because
  // most messages of a run are of these two kinds.
  [[gnu::always_inline]] int32_t PostAtOnce(OwnedMessage message) {
    Message* const posted = message.release();
    Object* const target = object(posted->target);
    return poster_.PostAtOnce(posted, target) ? sSUCCESS : PostByCalls(posted);
  }

  // Ends the running handler without returning to it, as exit() and Exit() do.  REQUIRES: called in
  // a handler.
  [[noreturn]] void AbandonHandler();

  // Replaces the schedule that the seed has chosen.  The schedule decides the order of messages;
  // tests and tools use schedules to try other orders.  The System does not own the schedule, so it
  // must exist as long as the System delivers messages.  Null means no schedule.  REQUIRES: before
  // Boot().
  void set_schedule(Schedule* schedule);
  // Puts into the queue again a message that a gate or the processor (cpu.h) has held.  The message
  // is due now and comes before all others of its class and priority.
  void Readmit(OwnedMessage message);

  Inputs& inputs() { return inputs_; }
  const Inputs& inputs() const { return inputs_; }
  ConsoleInput& console_input() { return console_input_; }
  TimeEvents& time_events() { return time_events_; }
  Requests& requests() { return requests_; }
  RobotTable& robot_table() { return robot_table_; }
  const RobotTable& robot_table() const { return robot_table_; }

  // ---- State of the run ----

  ObjectTable& object_table() { return table_; }
  // The next three functions are short forms for functions of object_table().
  Object* object(ObjectId id) const { return table_.Get(id); }
  Object* FindObject(int robot, std::string_view name) const { return table_.Find(robot, name); }
  const std::vector<std::unique_ptr<Object>>& objects() const { return table_.all(); }

  RegionTable& regions() { return regions_; }
  const RegionTable& regions() const { return regions_; }
  RegionShares& region_shares() { return region_shares_; }
  HostAddresses& host_addresses() { return host_addresses_; }
  // Null if no read-only copies of sent data are made.
  GuardPages* guard_pages() { return guard_pages_.get(); }
  // Returns how long a frame of the robot's devices lasts in virtual time: kFrameUs, or the length
  // that the cost model gives.
  int64_t frame_us() const { return options_.cost ? options_.cost->FrameUs() : kFrameUs; }
  Trace& trace() { return trace_; }
  const Findings& findings() const { return findings_; }
  const SystemOptions& options() const { return options_; }
  MessageQueue& queue() { return poster_.queue(); }
  MessagePoster& poster() { return poster_; }
  SystemCalls& calls() { return *calls_; }
  // The next two functions do the same as the functions of calls() with the same names.  If calls()
  // is LocalCalls, they call the RegionTable directly, as LocalCalls would do, which saves a
  // virtual call.
  bool PinRegion(uint32_t region) {
    return calls_are_local_ ? regions_.Pin(region) : calls_->PinRegion(region);
  }
  bool UnpinRegion(uint32_t region) {
    return calls_are_local_ ? regions_.Unpin(region) : calls_->UnpinRegion(region);
  }
  Dispatcher& dispatcher() { return *dispatcher_; }
  ObjectManager& manager() { return *manager_; }

  uint64_t trace_hash() const { return trace_.hash(); }
  uint64_t state_hash();
  uint64_t message_count() const { return trace_.count(); }

  // Adds a finding about the current object, or about the system if there is no current object.
  void AddFinding(Severity severity, std::string text);
  void AddFindingAbout(const Object* object, Severity severity, std::string text);
  // Adds a finding about the stick or the configuration of a robot.  `cause` and `place` are the
  // members of Finding with these names.
  void AddFindingAboutRobot(int robot, Severity severity, std::string text, std::string cause = {},
                            std::string place = {});
  // Adds a finding to findings() of this process.  Called by LocalCalls::AddFinding().
  void RecordFinding(const Object* object, Severity severity, std::string text);

  // Prints text of an object or of the system to SystemOptions::console.
  void Print(std::string_view text);

 private:
  CodeObject* FinishCodeObject(Object* host, std::unique_ptr<CodeObject> code);
  Object* NewCodeHost(int robot, const std::string& name);

  int32_t PostByCalls(Message* message);

  SystemOptions options_;
  // True if `calls_` is LocalCalls, which works on the tables of this System and not on those of
  // another process.  Functions that run for every notification, such as PinRegion(), then use
  // these tables directly, which saves a virtual call.
  const bool calls_are_local_;
  const std::unique_ptr<SystemCalls> calls_;

  MessagePoster poster_;  // has the pool of messages, so it is destroyed after the members below
  RegionTable regions_;
  RegionShares region_shares_{&regions_};
  std::unique_ptr<GuardPages> guard_pages_;
  HostAddresses host_addresses_;
  Trace trace_;
  Findings findings_;
  Inputs inputs_{this};
  ConsoleInput console_input_{this};
  TimeEvents time_events_{this};
  Requests requests_{this};
  std::unique_ptr<RunFolder> run_folder_;
  RobotTable robot_table_{this};
  std::unique_ptr<Dispatcher> dispatcher_;
  ObjectManager* manager_ = nullptr;
  // The ObjectTable is the last member of System, so it is destroyed first: objects use the other
  // members until they are destroyed.
  ObjectTable table_{this};
};

template <typename T, typename... Args>
T* System::AddObject(int robot, const std::string& name, Args&&... args) {
  Object* const host = NewCodeHost(robot, name);
  const CurrentScope scope(this, host);
  auto code = std::make_unique<T>(std::forward<Args>(args)...);
  T* const result = code.get();
  FinishCodeObject(host, std::move(code));
  return result;
}

}  // namespace openr_host
