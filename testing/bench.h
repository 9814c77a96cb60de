// Bench: a robot, or a part of one, on the table of a test.
//
//   #include <openr/testing.h>
//   using namespace openr::testing;
//
//   TEST(BlinkerTest, BlinksOnceASecond) {
//     Bench bench;
//     bench.AddImage(BLINKER_BIN);                              // the object, as built
//     ProbeObserver& light = bench.Watch("Blinker.Light.int.S");
//     bench.Boot();
//     bench.RunFor(2s);
//     EXPECT_EQ(light.values<int>(), (std::vector{1, 0}));
//   }
//
// Everything is virtual: a run is a function of the bench, its seed and what the test does,
// and repeats itself bit for bit.  A verb that cannot do what it says fails the test at its
// line, says what happened last, who waits for whom and how to see it again, and returns
// false.  A bench belongs to one test and one thread.  docs/testing.md is the tutorial.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/core/system.h"
#include "testing/bench_schedule.h"
#include "testing/bench_stick.h"
#include "testing/control.h"
#include "testing/doors.h"
#include "testing/expectations.h"
#include "testing/history.h"
#include "testing/message_spec.h"
#include "testing/place.h"
#include "testing/probe.h"
#include "testing/story_teller.h"
#include "testing/tcp_client.h"

namespace openr_host {
class IpStack;
class LoopbackHub;
class VirtualRobot;
struct RobotModel;
struct World;
}  // namespace openr_host

namespace openr::testing {

using namespace std::chrono_literals;  // 8ms, 2s
using Duration = std::chrono::microseconds;

class Bench;

// What runs in place of an object of a stick.
struct StandIn {
  // By default a Probe with the services that CONNECT.CFG names for the object: those whose
  // first part is its name.
  StandIn(const char* the_object) : object(the_object) {}
  StandIn(std::string the_object, std::function<void(Bench&)> the_make)
      : object(std::move(the_object)), make(std::move(the_make)) {}

  std::string object;                // "JointMover", or the file of its image, "JOINTMOV.BIN"
  std::function<void(Bench&)> make;  // adds something to the bench
};

// The stick that comes with openr-host: the dog that stands up.  Throws std::runtime_error
// when it is nowhere.
std::string DefaultStick();

// Seed 1, or the number in the environment variable OPENR_SEED.
uint64_t SeedOfEnvironment();

struct BenchOptions {
  std::string stick = "";             // folder that holds OPEN-R/, copied; "": an empty stick
  std::vector<StandIn> replace = {};  // objects of the stick that others stand in for
  std::string body = "none";          // "none": no OVirtualRobotComm; "ideal"; "ode"
  std::string robot = "ers210";       // name of a model
  std::string world = "";             // a world file; "": a flat floor
  std::string battery = "drain";      // full at boot; "100%" stays full; "N%": so much at boot
  uint64_t seed = SeedOfEnvironment();
  bool strict = false;                               // limits of the robot are enforced
  std::shared_ptr<openr_host::CostModel> cost = {};  // what handlers cost; null: nothing
  // Objects get copies of what they receive, read-only and gone once they have said ready:
  // one that does otherwise is an error finding, or crashes at the line that does it.
  bool guard_regions = false;
  bool measure_stacks = false;  // Object::stack_max
  bool allow_threads = false;   // accepts other threads in the process; they must not touch it
  // A handler that uses more processor time ends the process with a failure that names it; 0s:
  // never, for a debugger.
  std::chrono::microseconds handler_limit = std::chrono::seconds(10);
};

class Bench {
 public:
  // Loads the stick.  Throws std::runtime_error when stick, model or world cannot be used.
  explicit Bench(BenchOptions options = {}, Place place = Place::Here());
  // Verifies what is still open, if a test is running that has not failed fatally.
  ~Bench();
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  // ---- Building: before Boot()

  // Loads an object image of the host, e.g. the file that openr_add_object() built, as
  // /MS/OPEN-R/MW/OBJS/<its name>.  Throws std::runtime_error that says what is wrong with it.
  openr_host::Object& AddImage(const std::string& file);

  // An object built in code, a CodeObject.
  template <typename T, typename... Args>
  T& Add(const std::string& name, Args&&... args) {
    return *system().AddObject<T>(0, name, std::forward<Args>(args)...);
  }
  // An object with these services for the test to use.
  Probe& AddProbe(const std::string& name, const std::vector<std::string>& services);

  // Connects a subject with an observer, by full names, as a line of CONNECT.CFG.
  void Wire(const std::string& subject, const std::string& observer);

  // A new probe with the other end of a service, wired to it.  The service may be named by its
  // first parts ("Blinker.Light") once its object is on the bench.
  ProbeObserver& Watch(const std::string& subject);
  ProbeSubject& Feed(const std::string& observer);

  // The probe of that name, also one that stands in for an object of the stick.  Throws
  // std::invalid_argument when there is none.
  Probe& probe(const std::string& name);

  // DoInit of all objects, connections, DoStart of all, until the last has returned.
  bool Boot(Place place = Place::Here());

  // ---- Running

  // The next message, moving the clock if need be.  False, without a failure, when there
  // is none.
  bool Step(Place place = Place::Here());

  // Until the next handler of an object ("JointMover") or of a service ("JointMover.Mover")
  // has returned, or waits; or that of the next message of a kind.
  bool StepTo(const std::string& end, Duration budget = 10s, Place place = Place::Here());
  bool StepTo(const MessageSpec& spec, Duration budget = 10s, Place place = Place::Here());
  // Until the message of that number has been handled: what failures say to see them again.
  bool StepToMessage(uint64_t number, Place place = Place::Here());

  bool RunFor(Duration duration, Place place = Place::Here());
  // Until `predicate`, asked after every message, holds.
  bool RunUntil(const std::function<bool()>& predicate, Duration budget,
                Place place = Place::Here());
  // Until everything expected has happened.
  bool RunUntilMet(Duration budget, Place place = Place::Here());

  // To the next boundary of 8 ms frames, with all that is due there.
  bool Frame(int count = 1, Place place = Place::Here());
  // To the end of the next sensor vector (4 frames), with all that is due then.  Needs a body.
  bool SensorVector(int count = 1, Place place = Place::Here());
  // One step of the body; nobody has heard of it yet.  Needs a body.
  bool PhysicsStep(Place place = Place::Here());

  // ---- Interfering

  // Posts a message as if its sender had.  The ends must be connected objects of the bench.
  // Notify("Blinker.Light", "Eye.Light"): `data` arrives whether Eye is ready or not.
  // ToEntry("Blinker", "Alarm").From("Clock"): `data` are the bytes of the message.
  template <typename T>
  bool Inject(const MessageSpec& spec, const T& data, Place place = Place::Here()) {
    static_assert(std::is_trivially_copyable_v<T>, "what objects send each other is plain data");
    return InjectBytes(spec, {reinterpret_cast<const char*>(&data), sizeof data}, place);
  }
  // Ready("Eye.Light", "Blinker.Light"), NotReady(...), or an entry without data.
  bool Inject(const MessageSpec& spec, Place place = Place::Here()) {
    return InjectBytes(spec, {}, place);
  }
  bool InjectBytes(const MessageSpec& spec, std::string_view bytes, Place place = Place::Here());

  // Where the robot leaves the order open (whose DoStart is next, whose message of those due
  // at the same time), these objects come first, in this order.
  void Reorder(std::vector<std::string> objects, Place place = Place::Here());

  // What the next three are asked to do has to happen until the end, or the test fails; where it
  // need not, ask with .Optional(): bench.Drop(Notify("Blinker.Light")).Optional().

  // Keeps what is on its way, from now on.
  HeldMessages& Hold(const MessageSpec& spec, Place place = Place::Here());
  HeldMessages& Hold(const std::string& subject, const std::string& observer,
                     Place place = Place::Here()) {
    return Hold(Notify(subject, observer), place);
  }
  // The next `count` messages get lost on their way.
  DroppedMessages& Drop(const MessageSpec& spec, int count = 1, Place place = Place::Here());
  // The n-th message of a kind from now on finds the receiver's queue full: its sender is
  // told so (sFULLMSGQENTRY), as on a robot whose queue holds 32.
  RefusedMessage& Refuse(const MessageSpec& spec, uint64_t nth = 1, Place place = Place::Here());
  // What is sent from now on takes longer, in order; 0: as before.
  void Delay(const MessageSpec& spec, Duration extra, Place place = Place::Here());

  // ---- Expecting; see expectations.h for the rules

  void Expect(const MessageSpec& spec, Place place = Place::Here());
  void Allow(const MessageSpec& spec, Place place = Place::Here());
  void Disallow(const MessageSpec& spec, Place place = Place::Here());
  // The same for data over a connection.
  void Expect(const std::string& from, const std::string& to, Place place = Place::Here()) {
    Expect(Notify(from, to), place);
  }
  void Expect(const std::string& from, const std::string& to, const PayloadMatcher& payload,
              Place place = Place::Here()) {
    Expect(Notify(from, to).With(payload), place);
  }
  void Allow(const std::string& from, const std::string& to, Place place = Place::Here()) {
    Allow(Notify(from, to), place);
  }
  void Disallow(const std::string& from, const std::string& to, Place place = Place::Here()) {
    Disallow(Notify(from, to), place);
  }
  void Disallow(const std::string& from, const std::string& to, const PayloadMatcher& payload,
                Place place = Place::Here()) {
    Disallow(Notify(from, to).With(payload), place);
  }
  void set_strict(bool strict, Place place = Place::Here()) {
    expectations_.set_strict(strict, place);
  }

  // An error the runtime notices fails the test, unless its text matches one of these; one
  // that is expected and never seen fails it too.
  void ExpectFinding(::testing::Matcher<const std::string&> text, Place place = Place::Here());
  void AllowFindings() { findings_allowed_ = true; }

  // Checks and forgets what is still expected: messages, findings, scripts of clients.
  void Verify();

  // ---- Looking

  int64_t now_us() const { return system_->now_us(); }
  const std::string& console() const { return console_; }  // what objects have printed
  // What the object said last after "state: " in its log; "" when nothing yet.
  const std::string& state(const std::string& object) const;

  // By name ("RF_j1", "head_led") or locator ("PRM:/r4/c1-Joint2:j1").  These throw
  // std::invalid_argument when there is none, and std::logic_error without a body.
  double JointDeg(std::string_view name) const;
  int64_t SensorValue(std::string_view name) const;  // in the sensor's OPEN-R unit
  int LedIntensity(std::string_view name) const;     // 0: dark
  double RollDeg() const;
  double PitchDeg() const;                     // right-handed: nose down is positive
  bool Standing(Place place = Place::Here());  // the rule of docs/cli.md, over the next 0.6 s
  openr_host::VirtualRobot& dog() const;
  const openr_host::RobotModel& model() const { return *model_; }

  // The button on the dog's back.  Needs a body.
  void PressPause();

  BenchStick& stick() { return *stick_; }

  // Somebody on another computer.
  TcpClient& AddClient();
  // The wire of the robot, for other peers and for names.
  const std::shared_ptr<openr_host::LoopbackHub>& network() const { return hub_; }

  const std::vector<openr_host::Finding>& findings() const { return system_->findings().all(); }
  std::string Findings() const;  // one line each
  uint64_t trace_hash() const { return system_->trace_hash(); }
  uint64_t state_hash() { return system_->state_hash(); }

  // Everything else.
  openr_host::System& system() { return *system_; }
  openr_host::Object& object(const std::string& name) const;  // throws std::invalid_argument
  // `see` is called for every message, just before its handler runs.
  void OnMessage(std::function<void(const SeenMessage&)> see) { see_.push_back(std::move(see)); }

  // What failures end with: the last messages, who waits for whom, how to see it again.
  std::string Story() const;

  // Called in a copy of the process; see snapshot.h.
  void OnCopied();

 private:
  struct ExpectedFinding {
    ::testing::Matcher<const std::string&> text;
    Place place;
    bool seen = false;
  };
  struct ServiceEnd {
    openr_host::ObjectId object;
    uint32_t selector;  // of its Ready or Notify entry
  };

  void AddDog();
  void LoadStick();
  std::vector<std::string> ServicesOf(const std::string& object);
  // Full names of all services that objects of the bench say they have.
  std::vector<std::string> KnownServices();
  // The full name of the one that `name` is, or is the beginning of.
  std::string FullName(const std::string& name, char direction);
  // Adds a probe with the other end of the service `given`; returns the probe and its service.
  std::pair<Probe*, std::string> AddOtherEnd(const std::string& given, char direction);

  // Runs `run` under control and reports what it was refused and found.  False when there
  // was anything to report.
  bool Control(const Place& place, const std::function<void()>& run);
  bool ReportFindings(const Place& place);
  void AllowFinding(size_t index) { told_.insert(index); }
  bool Miss(const Place& place, const std::string& what);  // a failure with the story; false
  bool IsRunning(const Place& place);                      // false, and a failure, before Boot()
  void See(const openr_host::Message& message);

  // A failure, now or after Boot(), when `spec` names objects or services there are not.
  bool CheckNames(const MessageSpec& spec, const Place& place);
  bool CheckName(const std::string& name, const Place& place);

  bool InjectNotify(const MessageSpec& spec, std::string_view bytes, const Place& place);
  bool InjectReady(const MessageSpec& spec, const Place& place);
  bool InjectEntry(const MessageSpec& spec, std::string_view bytes, const Place& place);
  static std::string CommandOf(uint64_t seed);
  bool AreConnected(const ServiceEnd& subject, const ServiceEnd& observer, const Place& place);
  std::optional<ServiceEnd> FindService(const std::string& name, const char* kind,
                                        const Place& place);

  const BenchOptions options_;
  const Place place_;  // where it was made
  std::unique_ptr<openr_host::RobotModel> model_;
  std::unique_ptr<openr_host::World> world_;
  std::shared_ptr<BenchStick> stick_;
  std::shared_ptr<openr_host::LoopbackHub> hub_;
  std::string console_;
  std::unique_ptr<openr_host::System> system_;
  BenchSchedule schedule_;
  Doors doors_;
  openr_host::VirtualRobot* dog_ = nullptr;
  openr_host::IpStack* ip_stack_ = nullptr;
  std::vector<TcpClient*> clients_;
  int last_probe_ = 0;  // of Watch() and Feed()

  History history_;
  Expectations expectations_;
  std::vector<std::function<void(const SeenMessage&)>> see_;
  std::optional<MessageSpec> goal_;  // of StepTo()
  uint64_t goal_number_ = 0;         // of StepToMessage()
  bool goal_reached_ = false;
  std::vector<std::pair<MessageSpec, Place>> unchecked_;  // names, until Boot()
  std::deque<ExpectedFinding> expected_findings_;
  bool findings_allowed_ = false;
  size_t findings_seen_ = 0;
  std::set<size_t> told_;                      // findings the test knows of already
  std::string command_;                        // that runs the test again
  std::unique_ptr<StoryTeller> story_teller_;  // the first to go: it looks at the others
};

}  // namespace openr::testing
