// Bench: a robot, or a part of one, for one test.
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
// Everything on a bench is virtual.  So a run depends only on the bench, its seed and the calls of
// the test, and repeats bit for bit.  A function that cannot do what the test asks for returns
// false, and the test fails at the line of the call.  The failure shows the last messages, the
// objects that wait and what they wait for, and how to repeat the run.  A bench belongs to one test
// and one thread.  docs/testing.md is the tutorial.
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

#include "runtime/core/post_as_object.h"
#include "runtime/core/system.h"
#include "testing/bench_schedule.h"
#include "testing/bench_stick.h"
#include "testing/control.h"
#include "testing/expectations.h"
#include "testing/history.h"
#include "testing/message_spec.h"
#include "testing/place.h"
#include "testing/probe.h"
#include "testing/story_teller.h"
#include "testing/tcp_client.h"
#include "testing/test_gate.h"

namespace openr_host {
class IpStack;
class LoopbackHub;
class VirtualRobot;
struct RobotModel;
struct World;
}  // namespace openr_host

namespace openr::testing {

using namespace std::chrono_literals;  // units of time: 8ms, 2s
using Duration = std::chrono::microseconds;

class Bench;

// A replacement for an object of the stick.  The bench adds it instead of loading the object's
// image.
struct StandIn {
  // Replaces the object by a Probe, an object through which the test sends and receives.  The probe
  // has the services that CONNECT.CFG names for the object.
  StandIn(const char* the_object) : object(the_object) {}
  StandIn(std::string the_object, std::function<void(Bench&)> the_make)
      : object(std::move(the_object)), make(std::move(the_make)) {}

  std::string object;  // name of the object, "JointMover", or file of its image, "JOINTMOV.BIN"
  std::function<void(Bench&)> make;  // a function that adds the replacement to the bench
};

// Returns the folder of the default stick, which comes with openr-host: its objects make the dog
// stand up.  Throws std::runtime_error when the folder is not found.
std::string DefaultStick();

// Returns the seed in the environment variable OPENR_SEED; 1 when the variable is not set.
uint64_t SeedOfEnvironment();

struct BenchOptions {
  // A folder that contains OPEN-R/, as a Memory Stick does.  The robot on the bench gets a copy of
  // this folder as its stick.  "": the stick is empty.
  std::string stick = "";
  std::vector<StandIn> replace = {};  // objects of the stick that are replaced
  // Kind of body: "none", "ideal" (joints follow exactly) or "ode" (physics).
  std::string body = "none";
  std::string robot = "ers210";  // name of a robot model
  // A world file, the user's own or one that came with the program ("corridor.json"); "": a flat
  // floor.
  std::string world = "";
  // The charge of the battery.  With "drain", the battery is full at boot and then drains as on the
  // robot, where it is empty after 90 minutes.  With "100%", it is always full.  With "N%", it has
  // N percent at boot and then drains.
  std::string battery = "drain";
  // The pictures of the camera.  With "world", the camera sees the robot's world.  With "pattern",
  // it sees a test pattern.  Any other text is a folder of pictures (.png, .ppm), which are shown
  // in the order of their names.
  std::string images = "world";
  uint64_t seed = SeedOfEnvironment();
  bool strict = false;  // whether the limits of the robot (memory, stack) are enforced
  // The virtual time that handlers take; null: handlers take no time.
  std::shared_ptr<openr_host::CostModel> cost = {};
  // Gives observers read-only copies of the data that they receive, to find two mistakes.  A write
  // to received data crashes at the line that writes.  A use of data after the observer has given
  // them back with AssertReady() is an error finding or a crash, because the copy is unmapped then.
  bool guard_regions = false;
  // True: measures how much stack each object uses (Object::stack_max).
  bool measure_stacks = false;
  // True: the process may have other threads, which must not touch the bench.
  bool allow_threads = false;
  // The processor time that one call of a handler may use.  A handler that uses more ends the
  // process with a failure that names the handler.  0s: no limit, as needed in a debugger.
  std::chrono::microseconds handler_limit = std::chrono::seconds(10);
};

class Bench {
 public:
  // Loads the stick.  Throws std::runtime_error when stick, model or world cannot be used.
  explicit Bench(BenchOptions options = {}, Place place = Place::Here());
  // Calls Verify(), if a test is running.  Does not call Verify() if the test has failed fatally
  // or throws an exception, because the test then ends early, before all that it expects can
  // happen.
  ~Bench();
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  // ---- Functions that build the bench; to be called before Boot()

  // Loads the image of an object, such as the file that openr_add_object() builds.  The image gets
  // the name /MS/OPEN-R/MW/OBJS/<name of `file`> on the stick.  Throws std::runtime_error if it
  // cannot be loaded.
  openr_host::Object& AddImage(const std::string& file);

  // Adds an object of class T, which derives from CodeObject.  Its code is in the test and not in
  // an image.
  template <typename T, typename... Args>
  T& Add(const std::string& name, Args&&... args) {
    return *system().AddObject<T>(0, name, std::forward<Args>(args)...);
  }
  // Adds an object with the services `services`, through which the test sends and receives.
  Probe& AddProbe(const std::string& name, const std::vector<std::string>& services);

  // Connects a subject with an observer by their full names, like a line of CONNECT.CFG.
  void Wire(const std::string& subject, const std::string& observer);

  // Adds a probe, and connects it with the subject `subject`, so that the probe receives what the
  // subject sends.  If the object of the subject is on the bench already, the first parts of the
  // subject's name are enough ("Blinker.Light").
  ProbeObserver& Watch(const std::string& subject);

  // Adds a probe, and connects it with the observer `observer`, so that the probe can send to the
  // observer.  `observer` may be a part of the name, as in Watch().
  ProbeSubject& Feed(const std::string& observer);

  // Returns the probe with this name, also if it replaces an object of the stick.  Throws
  // std::invalid_argument when the bench has no such probe.
  Probe& probe(const std::string& name);

  // Boots the robot: calls DoInit of all objects, makes the connections, and calls DoStart of all
  // objects.  Returns after the last DoStart.  Returns false, and reports a failure, if the robot
  // does not boot or an object makes an error during the boot.
  bool Boot(Place place = Place::Here());

  // ---- Functions that run the robot

  // Delivers the next message, and moves the clock to its time.  Returns false, without a failure,
  // when there is no message.
  bool Step(Place place = Place::Here());

  // Runs until `end`, an object ("JointMover") or a service ("JointMover.Mover"), has handled its
  // next message, or waits for a reply in its handler.  Reports a failure if no such message comes
  // within `budget` of virtual time.
  bool StepTo(const std::string& end, Duration budget = 10s, Place place = Place::Here());
  // Runs until the next message that fits `spec` was handled, or its handler waits for a reply.
  // Reports a failure if no such message comes within `budget` of virtual time.
  bool StepTo(const MessageSpec& spec, Duration budget = 10s, Place place = Place::Here());
  // Runs until the message with this number was handled, or its handler waits for a reply.
  // Failures print the numbers of messages, so with this function a test can stop where it failed.
  bool StepToMessage(uint64_t number, Place place = Place::Here());

  bool RunFor(Duration duration, Place place = Place::Here());
  // Runs until `predicate`, which is called after every message, returns true.  Reports a failure
  // if that takes longer than `budget` of virtual time.
  bool RunUntil(const std::function<bool()>& predicate, Duration budget,
                Place place = Place::Here());
  // Runs until all messages of Expect() have come.  If that takes longer than `budget` of virtual
  // time, reports a failure at the line of the first Expect() that was not met.
  bool RunUntilMet(Duration budget, Place place = Place::Here());

  // Runs through the next `count` frame boundaries (one every 8 ms of virtual time), and delivers
  // everything that is due at the last of them.
  bool Frame(int count = 1, Place place = Place::Here());
  // Runs to the end of the `count`-th sensor vector from now, and delivers everything that is due
  // at that time.  A sensor vector holds 4 frames of the body.  Needs a body (BenchOptions::body).
  bool SensorVector(int count = 1, Place place = Place::Here());
  // Runs until the body has made one more step.  Stops before any object receives data of that
  // step.  Needs a body.
  bool PhysicsStep(Place place = Place::Here());

  // ---- Messages that the test posts, delays, drops or refuses

  // Posts a message with the data `data`, as if its sender had posted it.  `spec` is one of two
  // kinds.  Notify("Blinker.Light", "Eye.Light") names two connected services; Eye receives `data`
  // even if it is not ready.  ToEntry("Blinker", "Alarm").From("Clock") names an entry (handler) of
  // Blinker and a sender; the message consists of the bytes of `data`.
  template <typename T>
  bool Inject(const MessageSpec& spec, const T& data, Place place = Place::Here()) {
    static_assert(std::is_trivially_copyable_v<T>, "what objects send each other is plain data");
    return InjectBytes(spec, {reinterpret_cast<const char*>(&data), sizeof data}, place);
  }
  // Posts a message without data.  `spec` is Ready("Eye.Light", "Blinker.Light"), a NotReady() with
  // the same names, or a ToEntry().
  bool Inject(const MessageSpec& spec, Place place = Place::Here()) {
    return InjectBytes(spec, {}, place);
  }
  bool InjectBytes(const MessageSpec& spec, std::string_view bytes, Place place = Place::Here());

  // Makes the objects `objects` go first, in this order, where the robot leaves the order open:
  // when objects start, and when several objects have a message due at the same time.
  void Reorder(std::vector<std::string> objects, Place place = Place::Here());

  // Hold(), Drop() and Refuse() make the test fail if too few fitting messages come.  Optional()
  // lets the test pass nevertheless: bench.Drop(Notify("Blinker.Light")).Optional().

  // From now on, holds back messages that fit `spec`, until the test releases them.
  HeldMessages& Hold(const MessageSpec& spec, Place place = Place::Here());
  HeldMessages& Hold(const std::string& subject, const std::string& observer,
                     Place place = Place::Here()) {
    return Hold(Notify(subject, observer), place);
  }
  // Drops the next `count` messages that fit `spec`.
  DroppedMessages& Drop(const MessageSpec& spec, int count = 1, Place place = Place::Here());
  // Delivers the n-th message that fits `spec`, counted from now, twice: when the message is
  // delivered, the bench posts a message with the same data once more.  A message with several
  // data is repeated as one message for each datum.  If the message is a reply, such as the answer
  // to Call() (MCOOP.h), the test fails, because a request gets only one reply.
  RepeatedMessage& Repeat(const MessageSpec& spec, uint64_t nth = 1, Place place = Place::Here());
  // Refuses the n-th message that fits `spec`, counted from now: the message is not posted, and its
  // sender gets sFULLMSGQENTRY, as on a robot when the queue of the receiver holds 32 messages.
  RefusedMessage& Refuse(const MessageSpec& spec, uint64_t nth = 1, Place place = Place::Here());
  // Delays messages that fit `spec` by `extra` from now on, and keeps their order.  0 ends the
  // delay.
  void Delay(const MessageSpec& spec, Duration extra, Place place = Place::Here());

  // ---- Expected and unexpected messages; see expectations.h for the rules

  void Expect(const MessageSpec& spec, Place place = Place::Here());
  void Allow(const MessageSpec& spec, Place place = Place::Here());
  void Disallow(const MessageSpec& spec, Place place = Place::Here());
  // The next functions are Expect(), Allow() and Disallow() for notifications from the subject
  // `from` to the observer `to`.
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

  // Expects a finding, such as an error of an object, with a text that the matcher `text` accepts.
  // The test fails if no such finding comes.  The test also fails at every error finding that no
  // call of ExpectFinding() expects, unless the test calls AllowFindings().
  void ExpectFinding(::testing::Matcher<const std::string&> text, Place place = Place::Here());
  void AllowFindings() { findings_allowed_ = true; }

  // Reports a failure for everything that the test has asked for and that has not happened:
  // expected messages and findings, messages to hold, drop or refuse, and steps of network clients.
  // A second call does not report the same failures again.
  void Verify();

  // ---- State of the robot and of the objects

  int64_t now_us() const { return system_->now_us(); }
  const std::string& console() const { return console_; }  // text that objects have printed
  // Returns the object's state.  An object reports its state by an INFO line (OSYSLOG1) that begins
  // with "state: ".  The result is the rest of the last such line; "" if there is none.
  const std::string& state(const std::string& object) const;

  // Return the state of a device.  `name` is the name of the device ("RF_j1", "chin", "head_led")
  // or its locator ("PRM:/r4/c1-Joint2:j1").  The functions throw std::invalid_argument if the
  // robot has no such device, and std::logic_error if the robot has no simulated body.
  double JointDeg(std::string_view name) const;
  int64_t SensorValue(std::string_view name) const;  // value in the sensor's OPEN-R unit
  int LedIntensity(std::string_view name) const;     // brightness of the light; 0: dark
  double RollDeg() const;
  double PitchDeg() const;  // pitch; positive when the nose points down
  // Runs for 0.6 s and returns whether the dog then stands (docs/cli.md has the rule).
  bool Standing(Place place = Place::Here());
  openr_host::VirtualRobot& dog() const;
  const openr_host::RobotModel& model() const { return *model_; }

  // ---- Actions of a person on the dog; docs/inputs.md
  //
  // Each of these functions adds an input, which takes effect at the next frame boundary, or at
  // once if the bench is at a frame boundary.  If the input is refused, for example because the dog
  // has no such sensor, the test fails at the line of the call and the function returns false.

  // Adds any input: "press chin for 300ms", "send Blinker.Alarm 5", "type hello".
  bool Do(std::string_view input, Place place = Place::Here());

  // Presses a sensor that people touch: "back", "chin", "head", "paw_LF" ..., for a duration or
  // until Release().
  bool Press(std::string_view sensor, Duration duration = 0s, Place place = Place::Here());
  bool Release(std::string_view sensor, Place place = Place::Here());
  // Makes a sensor read `value`, in the OPEN-R unit of the sensor.
  bool SetSensor(std::string_view sensor, int32_t value, Place place = Place::Here());
  // Presses the pause button on the dog's back.  That cuts the motor power and sets the pause bit
  // of the power status, which objects can watch.
  bool PressPause(Place place = Place::Here()) { return Do("press pause", place); }

  // A force in N: x points forward, y to the dog's left, z up.
  struct Force {
    double x = 0, y = 0, z = 0;
  };
  // Pushes the middle of the dog's trunk.  Needs a body with physics.
  bool Push(const Force& force, Duration duration = 100ms, Place place = Place::Here());
  // The next functions move the dog as a person's hand does: they lift the dog by `metres`, hold it
  // at its place, set it down, or let it fall.
  bool Lift(double metres = 0.2, Place place = Place::Here());
  bool HoldDog(Place place = Place::Here()) { return Do("hold", place); }
  bool SetDown(Place place = Place::Here()) { return Do("setdown", place); }
  bool LetGo(Place place = Place::Here()) { return Do("letgo", place); }

  bool SetBattery(int percent, Place place = Place::Here());
  bool SetCharger(bool on, Place place = Place::Here());

  BenchStick& stick() { return *stick_; }

  // Adds a simulated network client.  The robot sees it as a program on another computer.  The
  // client's script says what it sends and expects.
  TcpClient& AddClient();
  // Returns the network that the robot is on.  A test can add other computers and host names to it.
  const std::shared_ptr<openr_host::LoopbackHub>& network() const { return hub_; }

  const std::vector<openr_host::Finding>& findings() const { return system_->findings().all(); }
  std::string Findings() const;  // returns a line of text for each finding
  uint64_t trace_hash() const { return system_->trace_hash(); }
  uint64_t state_hash() { return system_->state_hash(); }

  // system() and object() give access to everything that the functions above do not offer.
  openr_host::System& system() { return *system_; }
  // Returns the object called `name`; throws std::invalid_argument if there is no such object.
  openr_host::Object& object(const std::string& name) const;
  // Makes the bench call `see` for every message, just before its handler runs.
  void OnMessage(std::function<void(const SeenMessage&)> see) { see_.push_back(std::move(see)); }

  // Returns the text that is added to each failure: the last messages, the objects that wait and
  // what they wait for, and how to repeat the run.
  std::string Story() const;

  // Makes this bench independent of the bench in the original process: copies its stick and notes
  // the running test.  Snapshot calls OnCopied() in each copy of the process, because copies must
  // share no files.
  void OnCopied();

 private:
  struct ExpectedFinding {
    ::testing::Matcher<const std::string&> text;
    Place place;
    bool seen = false;
  };

  void AddDog();
  void LoadStick();
  // Returns the name of the object in the image `path` of the stick; "" if the file is no image.
  std::string NameInImage(const std::string& path);
  std::vector<std::string> ServicesOf(const std::string& object);
  // Returns the full names of all services of the objects on the bench.
  std::vector<std::string> KnownServices();
  // Returns the full name of a service.  `name` is the full name or its first parts, such as
  // "RCServer.Mover".  `direction` is 'S' for a subject, 'O' for an observer.  If only services of
  // the other direction fit, returns one of them, so that the caller can report this mistake.
  // Throws std::invalid_argument when no service fits, or several do.
  std::string FullName(const std::string& name, char direction);
  // Adds a probe with one service, a subject if `direction` is 'S' and an observer if it is 'O'.
  // Connects the probe with `given`, a service of the other direction.  Returns the probe and the
  // full name of the probe's service.
  std::pair<Probe*, std::string> AddOtherEnd(const std::string& given, char direction);

  // Calls `run`, which lets the robot run.  During the call, objects cannot make threads or
  // sockets, because a run with threads or sockets cannot be repeated.  Reports each refusal, and
  // each error that the runtime has found in an object, as a failure.  Returns false if there were
  // such failures.
  bool RunControlled(const Place& place, const std::function<void()>& run);
  bool ReportFindings(const Place& place);
  void AllowFinding(size_t index) { thrown_findings_.insert(index); }
  // Reports the failure `what` at the line `place`, with the last messages and the states of the
  // objects (Story()).  Always returns false, so that a caller can return this result.
  bool ReportFailure(const Place& place, const std::string& what);
  // Returns whether Boot() was called; if not, reports a failure.
  bool IsRunning(const Place& place);
  void HandleMessage(const openr_host::Message& message);

  // Checks that the objects and services that `spec` names exist.  If one of them does not exist,
  // reports a failure and calls `on_wrong`, which may be null.  Before Boot() some services are not
  // known yet, so a call before Boot() only stores `spec`, and Boot() makes the check.
  void CheckNames(const MessageSpec& spec, const Place& place,
                  const std::function<void()>& on_wrong = {});
  bool CheckName(const std::string& name, const Place& place);

  // A call of a Bench function that posts a message, such as Inject().  A failure names the
  // function and points to the line of the call.
  struct Caller {
    const char* function;
    Place place;  // line that calls `function`
  };
  void PostAgain(const SeenMessage& message, const Place& place);
  bool PostBytes(const MessageSpec& spec, std::string_view bytes, const Caller& caller);
  bool PostNotify(const MessageSpec& spec, std::string_view bytes, const Caller& caller);
  bool PostReadiness(const MessageSpec& spec, const Caller& caller);
  bool PostEntry(const MessageSpec& spec, std::string_view bytes, const Caller& caller);
  // Reports a failure at the line of the call `caller`: the message that this call should have
  // posted was not posted, for the reason `problem`.  Always returns false.
  bool MissPost(const Caller& caller, const std::string& problem);
  static std::string CommandOf(uint64_t seed);
  // Returns the subject or the observer (`side`) with the name `name`; the first parts of its full
  // name are enough.  If no object has such a service, reports a failure.
  std::optional<openr_host::ServiceEnd> FindEnd(const std::string& name,
                                                openr_host::ServiceSide side, const Caller& caller);

  const BenchOptions options_;
  const Place place_;  // line of the test that made the bench
  std::unique_ptr<openr_host::RobotModel> model_;
  std::unique_ptr<openr_host::World> world_;
  std::shared_ptr<BenchStick> stick_;
  std::shared_ptr<openr_host::LoopbackHub> hub_;
  std::string console_;
  std::unique_ptr<openr_host::System> system_;
  BenchSchedule schedule_;
  TestGate gate_;
  openr_host::VirtualRobot* dog_ = nullptr;
  openr_host::IpStack* ip_stack_ = nullptr;
  std::vector<TcpClient*> clients_;
  int last_probe_ = 0;  // number of probes that Watch() and Feed() have added so far

  History history_;
  Expectations expectations_;
  std::vector<std::function<void(const SeenMessage&)>> see_;
  // StepTo() stops at the next message that fits `goal_`; nullopt while StepTo() does not run.
  std::optional<MessageSpec> goal_;
  // Number of the message at which StepToMessage() stops; 0 while it does not run.
  uint64_t goal_number_ = 0;
  bool goal_reached_ = false;
  // A MessageSpec that the test gave before Boot().  Boot() checks that its objects and services
  // exist.
  struct UncheckedNames {
    MessageSpec spec;
    Place place;                     // line of the test that gave `spec`
    std::function<void()> on_wrong;  // called if a name in `spec` is wrong; may be null
  };
  std::vector<UncheckedNames> unchecked_;
  std::deque<ExpectedFinding> expected_findings_;
  bool findings_allowed_ = false;
  size_t findings_seen_ = 0;
  std::set<size_t> thrown_findings_;  // indices of findings that an exception has reported
  std::string command_;               // command that runs the test again
  // Must be the last member, because its destructor uses the other members.
  std::unique_ptr<StoryTeller> story_teller_;
};

}  // namespace openr::testing
