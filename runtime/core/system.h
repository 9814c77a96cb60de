// System: the clock, the queue, the objects and everything they share.
//
// One System is one deterministic run.  It has no global state; several may live
// in one process, each used from one thread.  Data flows: stick -> wiring ->
// objects -> messages -> objects; virtual robots and the IPStack are objects too.
//
//   System system({.seed = 1});
//   const int dog = system.AddRobot("ERS-210", stick);
//   AddVirtualRobot(&system, dog, ...);           // virtualrobot/
//   LoadStick(&system, dog);                      // load_stick.h: images of OBJECT.CFG, wiring of
//   CONNECT.CFG system.Boot(); system.RunFor(30'000'000);
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/base/rng.h"
#include "runtime/core/console_input.h"
#include "runtime/core/cpu.h"
#include "runtime/core/current.h"
#include "runtime/core/findings.h"
#include "runtime/core/host_addresses.h"
#include "runtime/core/message.h"
#include "runtime/core/object.h"
#include "runtime/core/region_shares.h"
#include "runtime/core/region_table.h"
#include "runtime/core/requests.h"
#include "runtime/core/run_end.h"
#include "runtime/core/schedule.h"
#include "runtime/core/system_calls.h"
#include "runtime/core/time_events.h"
#include "runtime/core/trace.h"

namespace openr_host {

class CodeObject;
class Dispatcher;
class GuardPages;
class Hasher;
class MemoryStick;
class ObjectManager;
class RobotServices;
class RunFolder;

// 8 ms: the unit of everything the robot does.
constexpr int64_t kFrameUs = 8000;

// RAM of the robot, for the system and all objects (field-notes.md 3.10).
constexpr size_t kRobotMemoryBytes = size_t{32} << 20;

struct SystemOptions {
  // 1 is the canonical order; any other one draws an order the robot allows, and all
  // that is random.
  uint64_t seed = 1;
  // Turns findings that stop a robot into the robot's behaviour; what objects receive is a
  // read-only copy.
  bool strict = false;
  // Receives what objects print; null: standard output.
  std::function<void(std::string_view text)> console = {};
  // OSYSLOG lines of a priority above this are not printed (1 error, 2 warning, 3 info).
  uint32_t log_level = 3;
  // Messages delivered at one instant before each further one takes 1 us: objects that
  // answer each other without waiting must not stop the clock.
  int64_t free_deliveries = 10'000;
  // Wall clock in nanoseconds for handler_ns_max; null: not measured.  Nothing
  // else may depend on it.
  int64_t (*wall_clock_ns)() = nullptr;
  // What handlers cost; null: nothing.
  std::shared_ptr<CostModel> cost = {};
  // Whether Object::stack_max is measured, for images: in the first 64 handlers and in every
  // 16th from then on.
  bool measure_stacks = false;
  // What objects receive is a copy of their own, read-only, that is gone once they have
  // asserted ready; data changed on their way become an error finding.  Costs some us a
  // notification.
  bool guard_regions = false;
  // Makes the calls of handlers; null: LocalCalls, on the tables of this System.
  std::function<std::unique_ptr<SystemCalls>(System*)> make_calls = {};
};

// A wire of CONNECT.CFG, or one made in code.
struct Connection {
  int robot = 0;
  std::string subject;  // four-part service names
  std::string observer;
  std::string where;  // "CONNECT.CFG:4" for messages
};

// A robot: its stick, its design, and the services of its objects.
struct Robot {
  int index = 0;
  std::string design;                  // "ERS-210"
  std::shared_ptr<MemoryStick> stick;  // null: none in the slot
  std::unique_ptr<RobotServices> services;
  std::map<std::string, std::pair<ObjectId, uint32_t>> directory;  // service name -> entry
  std::map<std::string, std::string> design_data;                  // keyword -> /MS/ path
  std::map<std::string, ObjectId> names;                           // of Register() (MCOOP.h)
  MemoryBudget memory;                                             // limited with --strict
  uint64_t stick_hash = 0;  // of the stick as LoadStick() found it
  bool powered_off = false;
  std::optional<RunEnd> end;  // why it goes off, or went; none: nothing has told it to
};

class System {
 public:
  explicit System(SystemOptions options = {});
  ~System();
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  // ---- Building, before Boot() ----

  // Returns the robot's index.
  int AddRobot(const std::string& design, std::shared_ptr<MemoryStick> stick);
  Robot& robot(int index) { return *robots_.at(static_cast<size_t>(index)); }
  int robot_count() const { return static_cast<int>(robots_.size()); }

  // Takes in an object made elsewhere, whose id is the next: objects().size().
  Object* Adopt(std::unique_ptr<Object> object);
  ObjectId NextObjectId() const { return static_cast<ObjectId>(objects_.size()); }

  // Makes an object of class T (a CodeObject) with the arguments given.  Its
  // constructor runs as code of the new object.
  template <typename T, typename... Args>
  T* AddObject(int robot, const std::string& name, Args&&... args);

  // The folder for copies of images, which goes with the System.
  RunFolder* run_folder();

  // REQUIRES: before Boot().
  void Connect(Connection connection) { connections_.push_back(std::move(connection)); }
  const std::vector<Connection>& connections() const { return connections_; }

  // As if made with this seed, but for the order of messages, which is the schedule's.
  // REQUIRES: before Boot().
  void Reseed(uint64_t seed);

  // Posts the boot: DoInit of all objects, connections, DoStart of all.
  void Boot();

  // Posts the replacement of an image by a fresh load of its file: DoStop and DoDestroy
  // of the old one, DoInit, its connections and DoStart of the new one, which begins
  // with fresh statics and an empty heap under the same OID.  Messages to the old one
  // are lost; what it was lent goes back.  An image that cannot be loaded is an error
  // finding and changes nothing.  REQUIRES: booted() and `id` names an image.
  void Reload(ObjectId id);

  // The same for objects whose code was elsewhere and is gone, as is all they had (EndAllOf()):
  // `fresh` have their ids and come in their place, all before the first DoInit.
  void Return(std::vector<std::unique_ptr<Object>> fresh);

  // Ends every connection of the others with object `id`, which has been replaced elsewhere.
  void Forget(ObjectId id);

  // Posts a call, which is made as soon as no message of an object is due.
  void PostTask(std::function<void()> task);

  // What `id` has of the system ends: time events, network connections, regions.  In a task:
  // messages on their way may point into regions.
  void EndAllOf(ObjectId id);
  // `listener` hears of it.
  void OnEnd(std::function<void(ObjectId)> listener) { end_listeners_.push_back(listener); }

  // `listener` hears of every object that is replaced, before its successor is there.
  void OnReplace(std::function<void(ObjectId)> listener) { replace_listeners_.push_back(listener); }

  // Posts the shutdown of one robot: DoStop of its objects, then DoDestroy; messages to
  // them are dropped from then on.
  void Shutdown(int robot, const RunEnd& why = {});
  void Shutdown(const RunEnd& why = {});             // of all
  bool booted() const { return booted_; }            // the last DoStart has returned
  bool powered_off() const { return powered_off_; }  // all robots are off; nothing runs
  // The robot stops at once, as OPENR::Fatal does.
  void PowerOff(int robot, const RunEnd& why = {});
  // Do the same with the tables of this process.
  void BeginShutdown(int robot, const RunEnd& why);
  void CutPower(int robot, const RunEnd& why);

  // Why a robot goes off, and why the run ends for a reason that is not one of its robots'.  The
  // first reason is kept, but for a PowerOff() during a shutdown.  Those two do it themselves.
  void NoteEnd(int robot, const RunEnd& why);
  void NoteRunEnd(const RunEnd& why);
  // Why the run has ended: what NoteRunEnd() was told, or, when all robots are off, the reason of
  // the one that went off last; none while it goes on.
  const std::optional<RunEnd>& end() const { return end_; }

  // ---- Running ----

  int64_t now_us() const { return now_us_; }

  // Delivers the next message, moving the clock if need be.  False when there is none.
  bool Step();

  // Delivers the next message if it is due by `time_us`; else leaves the clock there.
  void RunOne(int64_t time_us);

  // Delivers `count` messages, or all there are.
  void RunMessages(uint64_t count);

  // Delivers all that is due up to `time_us` and leaves the clock there.  Stops
  // early when the robot powers off.  REQUIRES: time_us >= now_us().
  void RunUntil(int64_t time_us);
  void RunFor(int64_t duration_us) { RunUntil(now_us_ + duration_us); }

  // Until `predicate` holds (asked after every message); false when `budget_us`
  // went by without.
  bool RunUntil(const std::function<bool()>& predicate, int64_t budget_us);

  // ---- Messages ----

  // A message from the current object (or the system) with an empty payload, to be
  // filled and posted.
  Message* NewMessage(ObjectId target, uint32_t selector);

  // Queues it, `delay_us` from now.  Returns an sError: sSUCCESS, sINVALIDOID,
  // or sFULLMSGQENTRY when the receiver's queue is full (--strict).
  int32_t Post(Message* message, int64_t delay_us = 0);

  // Queues a message of this process; Post() without the calls of the handler.
  int32_t Enqueue(Message* message, int64_t delay_us);

  // Ends the handler that runs, without returning to it.
  [[noreturn]] void AbandonHandler();

  // ---- Orders and doors, for tests and explorers; null: none.  They must outlive
  //      their use here.

  // Instead of the seed's.  REQUIRES: before Boot().
  void set_schedule(Schedule* schedule) { schedule_ = schedule; }
  void set_gate(Gate* gate) { gate_ = gate; }
  // A message that a gate or the processor kept goes first at this instant.
  void Readmit(Message* message);

  // What people type; enters at the next frame boundary.  Not from a handler.
  void FeedConsole(int robot, std::string_view text) { console_input_.Feed(robot, text); }
  // `listener` hears of it at once, for recordings.
  void OnConsoleInput(ConsoleInput::Listener listener) {
    console_input_.OnFeed(std::move(listener));
  }
  ConsoleInput& console_input() { return console_input_; }
  TimeEvents& time_events() { return time_events_; }
  Requests& requests() { return requests_; }

  // ---- Looking ----

  Object* object(ObjectId id) const;
  Object* FindObject(int robot, std::string_view name) const;
  const std::vector<std::unique_ptr<Object>>& objects() const { return objects_; }

  RegionTable& regions() { return regions_; }
  RegionShares& region_shares() { return region_shares_; }
  GuardPages* guard_pages() { return guard_pages_.get(); }  // null: received data are not copied
  // How long a frame of the devices lasts by this clock.
  int64_t frame_us() const { return options_.cost ? options_.cost->FrameUs() : kFrameUs; }
  Trace& trace() { return trace_; }
  const Findings& findings() const { return findings_; }
  const SystemOptions& options() const { return options_; }
  MessageQueue& queue() { return queue_; }
  SystemCalls& calls() { return *calls_; }
  Dispatcher& dispatcher() { return *dispatcher_; }

  uint64_t trace_hash() const { return trace_.hash(); }
  uint64_t state_hash();
  uint64_t message_count() const { return trace_.count(); }

  // About the current object, if any.
  void AddFinding(Severity severity, std::string text);
  void AddFindingAbout(const Object* object, Severity severity, std::string text);
  // About the stick or the configuration of a robot.
  void AddFindingAboutRobot(int robot, Severity severity, std::string text);
  // Adds it to findings() of this process.
  void RecordFinding(const Object* object, Severity severity, std::string text);

  // "JointMover waits for the answer of IPStack since t=1.248 s", one line each.
  std::vector<std::string> WhoWaits() const;

  void Print(std::string_view text);

 private:
  friend class Dispatcher;
  friend class ObjectManager;

  // Before Replace(): what is on its way to it comes to nobody.  Who was ready for it.
  std::vector<StandingReady> EndMessagesTo(Object* old);
  void Replace(std::unique_ptr<Object> fresh);
  std::vector<Message> TakeMessagesTo(Object* object);
  // As its observers would, which know nothing of its replacement.
  void AssertAgain(ObjectId id, const std::vector<StandingReady>& readies);
  CodeObject* FinishCodeObject(Object* host, std::unique_ptr<CodeObject> code);
  Object* NewCodeHost(int robot, const std::string& name);

  // Of processors, time events and the console.
  int64_t NextInstant() const;
  void DoWhatIsDue();
  friend class Cpu;
  int32_t RefuseSelector(Message* message, const Object& target);
  void ReportHostAddresses(const Message& message);
  // What came while `object` could not hear it is older than anything due now.
  void ReturnHeld(Object* object);

  SystemOptions options_;
  const std::unique_ptr<SystemCalls> calls_;
  int64_t now_us_ = 0;
  uint64_t last_number_ = 0;
  bool booted_ = false;
  bool powered_off_ = false;
  std::optional<RunEnd> end_;

  MessageQueue queue_;
  RegionTable regions_;
  RegionShares region_shares_{&regions_};
  std::unique_ptr<GuardPages> guard_pages_;
  HostAddresses host_addresses_;
  Trace trace_;
  Findings findings_;
  ConsoleInput console_input_{this};
  TimeEvents time_events_{this};
  Requests requests_{this};
  std::unique_ptr<RunFolder> run_folder_;
  std::vector<std::unique_ptr<Robot>> robots_;
  std::vector<std::unique_ptr<Object>> objects_;
  std::vector<std::unique_ptr<Object>> outlived_;  // replaced while a handler of theirs waited
  std::vector<Connection> connections_;
  std::unique_ptr<Dispatcher> dispatcher_;
  std::vector<std::unique_ptr<Cpu>> cpus_;  // by robot; none without a cost model
  std::unique_ptr<SeedSchedule> seed_schedule_;
  Schedule* schedule_ = nullptr;
  Gate* gate_ = nullptr;
  std::vector<std::function<void(ObjectId)>> end_listeners_;
  std::vector<std::function<void(ObjectId)>> replace_listeners_;
  ObjectManager* manager_ = nullptr;
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
