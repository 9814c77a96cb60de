// Tests of the things that a lost worker leaves behind in a run that goes on: reads of the console,
// regions, connections, its entry in the report.  Teller and Hearer are in workers; the probes are
// in this process.
#include <MCOOP.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include "distribution/worker_group.h"
#include "runtime/core/api.h"
#include "runtime/core/load_stick.h"
#include "runtime/core/system_inputs.h"
#include "tests/conformance/conform_fixture.h"
#include "tests/distribution/kill_process.h"
#include "tests/distribution/wait_until.h"
#include "tests/runtime/core/probe.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class Reader : public CodeObject {
 public:
  Reader() {
    read = AddExtra("Read", [this](void*) {
      char line[80];
      lines.emplace_back(line, system().console_input().Read(line, sizeof line));
    });
  }

  Selector read;
  std::vector<std::string> lines;
};

// Answers each question with "42".
class Asked : public CodeObject {
 public:
  Asked() {
    AddExtra("Question", [](void*) {
      char answer[] = "42";
      Reply(answer, sizeof answer);
    });
  }
};

// Sends Teller a question ("Ask"), and reads the answer when told to ("Look").
class Asker : public CodeObject {
 public:
  Asker() {
    AddExtra("Ask", [this](void* message) {
      char* const text = static_cast<char*>(message);
      SendWithRBox(teller, entry, text, std::strlen(text) + 1, &box);
    });
    AddExtra("Look", [this](void*) {
      char reply[32] = "(none)";
      size_t got = 0;
      Receive(box, reply, sizeof reply, &got);
      answer.assign(reply, got);
    });
  }

  OID teller;
  Selector entry = UNDEF;
  std::string answer;

 private:
  RID box;
};

class LeftBehindTest : public ConformTest {
 protected:
  LeftBehindTest() {
    static int number = 0;
    options_.bus.run = "left-" + std::to_string(getpid()) + "-" + std::to_string(++number);
    options_.stick = root;
    options_.restarts = 1;
    options_.say = [](const std::string&) {};
    options_.interrupts = [this] { return interrupts_(); };
    options_.command = {OPENR_PROGRAM, "join",          "--child-of", std::to_string(getpid()),
                        "--run-name",  options_.bus.run};
  }
  ~LeftBehindTest() override {
    if (workers_ != nullptr) workers_->End();
  }

  void Place(const std::map<std::string, std::string>& where) {
    options_.placement.process_of = where;
    workers_ = std::make_unique<WorkerGroup>(options_);
    SystemOptions options;
    options.console = [this](std::string_view text) { printed += text; };
    system = std::make_unique<System>(std::move(options));
    system->AddRobot("ERS-210", stick);
    reader_ = system->AddObject<Reader>(0, "reader");
    sender_ = system->AddObject<SubjectProbe>(0, "sender");
    receiver_ = system->AddObject<ObserverProbe>(0, "receiver");
    asked_ = system->AddObject<Asked>(0, "asked");
    asker_ = system->AddObject<Asker>(0, "asker");
    receiver_->on_start = [this] { receiver_->in->AssertReady(); };
    ASSERT_TRUE(LoadStick(system.get(), 0, workers_->StandInsFor(system.get(), 0)));
    ASSERT_EQ(workers_->Connect(), "");
    system->Boot();
  }

  WorkerGroup::ProcessFacts Process(const std::string& name) const {
    for (const WorkerGroup::ProcessFacts& facts : workers_->Describe()) {
      if (facts.name == name) return facts;
    }
    return {};
  }
  void Kill(const std::string& process) const { KillProcess(Process(process).pid, SIGKILL); }
  // Whether the process has ended with all its threads; a killed one may be a zombie.
  bool HasEnded(const std::string& process) const {
    namespace fs = std::filesystem;
    const std::string folder = "/proc/" + std::to_string(Process(process).pid);
    std::ifstream status(folder + "/stat");
    std::string id, name, state;
    if (!(status >> id >> name >> state)) return true;
    const fs::directory_iterator threads(folder + "/task");
    return state == "Z" && std::distance(begin(threads), end(threads)) == 1;
  }
  // Kills the process and waits until the run has noticed the loss.
  void Lose(const std::string& process) const {
    const int before = Process(process).losses;
    Kill(process);
    WaitUntil("the loss of " + process, [&] {
      workers_->CheckWorkers();
      return Process(process).losses > before;
    });
  }
  void Frame() const {
    system->RunFor(system->frame_us());
    workers_->CheckWorkers();
  }
  // Runs frames until the worker is restarted.  A restart takes no virtual time, but the run
  // notices it at a frame only.
  void ComeBack(const std::string& process) const {
    const auto is_away = [&] { return Process(process).restarts_done < Process(process).losses; };
    for (int i = 0; i < 10'000 && is_away(); ++i) Frame();
    EXPECT_FALSE(is_away()) << Process(process).lost;
  }
  void StartReading() const {
    system->Post(system->NewMessage(reader_->host().id, reader_->read));
    system->RunFor(1000);
  }
  // Returns the answer to a question for Teller; the asker waits for it, or reads it after it has
  // arrived.
  std::string AnswerTo(const std::string& question, bool waits) {
    asker_->teller = OidOf(IdOf("teller"));
    asker_->entry = EntryOf("teller", "Ask");
    Post("asker", "Ask", question);
    if (!waits) Settle();
    Post("asker", "Look", "");
    Settle();
    return asker_->answer;
  }
  void Type(const std::string& line) const {
    TypeText(system.get(), 0, line);
    system->RunFor(system->frame_us());
  }

  WorkerGroupOptions options_;
  std::function<int()> interrupts_ = [] { return 0; };
  std::unique_ptr<WorkerGroup> workers_;
  Reader* reader_ = nullptr;
  SubjectProbe* sender_ = nullptr;
  ObserverProbe* receiver_ = nullptr;
  Asked* asked_ = nullptr;
  Asker* asker_ = nullptr;
};

TEST_F(LeftBehindTest, ALostReaderOfTheConsoleTakesNoLine) {
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}}));
  Settle();
  Tell("gets");
  StartReading();
  Lose("acting");
  Type("one");
  StartReading();
  Type("two");
  EXPECT_THAT(reader_->lines, ElementsAre("one\n", "two\n"));
}

TEST_F(LeftBehindTest, ALineForALostReaderGoesToTheNextReader) {
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}}));
  Settle();
  Tell("gets");
  StartReading();
  TypeText(system.get(), 0, "mine");
  const int64_t frame_us = system->frame_us();
  EXPECT_TRUE(system->RunUntil([&] { return system->now_us() == frame_us; }, frame_us));
  Lose("acting");  // the line is in the System and has not been delivered
  system->RunFor(1000);
  EXPECT_THAT(reader_->lines, ElementsAre("mine\n"));
}

// The reader is killed after the run has checked it, and before the line arrives.
TEST_F(LeftBehindTest, ALineDoesNotGoToAKilledReaderBeforeTheLossIsNoticed) {
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}}));
  Settle();
  Tell("gets");
  StartReading();
  Kill("acting");
  WaitUntil("its end", [&] { return HasEnded("acting"); });
  Type("mine");
  EXPECT_THAT(reader_->lines, ElementsAre("mine\n"));
  EXPECT_EQ(Process("acting").losses, 1);
}

// Asker gets the answer that Teller gave, not the empty reply that the run sends for a lost object.
TEST_F(LeftBehindTest, AnAnswerBeforeTheLossIsKept) {
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}}));
  Settle();
  EXPECT_EQ(AnswerTo("answer and die", false), std::string("an answer", 10));
  EXPECT_EQ(Process("acting").losses, 1);
}

TEST_F(LeftBehindTest, AForwardedRequestIsAnsweredByItsReceiver) {
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}}));
  Settle();
  EXPECT_EQ(AnswerTo("bequeath", true), std::string("42", 3));
  EXPECT_EQ(Process("acting").losses, 1);
}

// The subject has sent more regions than messages may wait for one object, so the regions must come
// back several in a message.
TEST_F(LeftBehindTest, RegionsOfALostObserverComeBackInFewMessages) {
  Config("CONNECT.CFG", "Sender.Out.Number.S Hearer.In.Number.O\n");
  ASSERT_NO_FATAL_FAILURE(Place({{"hearer", "hearing"}}));
  Settle();
  Hear("auto");
  Hear("assert");
  std::vector<RCRegion*> regions;
  for (int i = 0; i < 40; ++i) {
    Hear("keep");
    RunAs(sender_, [&] {
      regions.push_back(new RCRegion(sizeof(int)));
      sender_->out->SetData(regions.back());
      sender_->out->NotifyObservers();
    });
    Settle();
    ASSERT_EQ(regions.back()->NumberOfReference(), 2);
  }
  Lose("hearing");
  Settle();
  EXPECT_FALSE(Found("Exceed max size")) << Findings();
  for (RCRegion* const region : regions) EXPECT_EQ(region->NumberOfReference(), 1);
  EXPECT_EQ(sender_->out->ReadyStatus(sender_->out->begin()->GetObserverID()), -1);
}

TEST_F(LeftBehindTest, NotificationsWaitingInALostSubjectAreCounted) {
  Place({{"teller", "acting"}, {"hearer", "hearing"}});
  Settle();
  Tell("send 5");  // the observer is not ready, so a notification waits in the subject
  Lose("acting");
  EXPECT_TRUE(Found("; 1 notifications that waited in it are lost; ")) << Findings();
}

// The robot does this with frame numbers in command vectors.
TEST_F(LeftBehindTest, BytesThatAnObserverWroteComeBackWithTheRegion) {
  Config("CONNECT.CFG", "Sender.Out.Number.S Hearer.In.Number.O\n");
  ASSERT_NO_FATAL_FAILURE(Place({{"hearer", "hearing"}}));
  Settle();
  Hear("assert");
  Hear("remember");
  RCRegion* region = nullptr;
  RunAs(sender_, [&] {
    region = new RCRegion(sizeof(int));
    std::memcpy(region->Base(), "\1\2\3\4", sizeof(int));
    sender_->out->SetData(region);
    sender_->out->NotifyObservers();
  });
  Settle();
  Hear("poke");
  Hear("assert");
  EXPECT_EQ(region->NumberOfReference(), 1);
  EXPECT_EQ(std::string(region->Base(), sizeof(int)), std::string(sizeof(int), '\0'));
}

TEST_F(LeftBehindTest, ARegionMadeBeforeTheRestartIsSentWithItsBytes) {
  Config("CONNECT.CFG",
         "Teller.Out.Number.S Receiver.In.Number.O\nSender.Out.Number.S Hearer.In.Number.O\n");
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "both"}, {"hearer", "both"}}));
  RCRegion* kept = nullptr;
  receiver_->on_notify = [&](const ONotifyEvent& event) {
    kept = event.RCData(0);
    kept->AddReference();
  };
  Settle();
  Tell("send 42");
  ASSERT_NE(kept, nullptr);
  Lose("both");
  ComeBack("both");
  Hear("assert");
  RunAs(sender_, [&] {
    sender_->out->SetData(kept);
    sender_->out->NotifyObservers();
  });
  Settle();
  EXPECT_THAT(printed, HasSubstr("H in 42 "));
  EXPECT_EQ(Process("both").losses, 1) << Process("both").lost;
}

TEST_F(LeftBehindTest, ServicesOfAnObjectLostDuringTheBootAreNoFinding) {
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}, {"hearer", "hearing"}}));
  Kill("acting");
  Settle();
  EXPECT_TRUE(Found("was killed by signal 9")) << Findings();
  EXPECT_FALSE(Found("NOT FOUND")) << Findings();
  ComeBack("acting");
  Hear("assert");
  Tell("send 5");
  EXPECT_THAT(printed, HasSubstr("H in 5 ")) << "its line of CONNECT.CFG is there again";
}

TEST_F(LeftBehindTest, AWrongConnectionIsReportedDespiteTheLoss) {
  Config("CONNECT.CFG",
         "Teller.Out.Number.S Hearer.In.Number.O\nTeller.Out.Number.S Receiver.On.Number.O\n"
         "Teller.Out.Number.S reader.In.Number.O\n");
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}, {"hearer", "hearing"}}));
  Kill("acting");
  Settle();
  EXPECT_TRUE(Found("Receiver.On.Number.O NOT FOUND")) << Findings();
  EXPECT_TRUE(Found("reader.In.Number.O NOT FOUND")) << Findings();
}

// The report waits for the restart, because only then the services of the object are known.
TEST_F(LeftBehindTest, AWrongConnectionOfALostObjectIsReportedAfterItsRestart) {
  Config("CONNECT.CFG",
         "Teller.Ot.Number.S Hearer.In.Number.O\nTelller.Out.Number.S Hearer.In.Number.O\n");
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}, {"hearer", "hearing"}}));
  Kill("acting");
  Settle();
  EXPECT_FALSE(Found("NOT FOUND")) << Findings();
  ComeBack("acting");
  EXPECT_TRUE(Found("Teller.Ot.Number.S NOT FOUND")) << Findings();
  EXPECT_TRUE(Found("Telller.Out.Number.S NOT FOUND")) << Findings();
  const size_t count = system->findings().all().size();
  Lose("acting");
  EXPECT_EQ(system->findings().all().size(), count + 1) << "said once";
}

// Process "a" has the observer and is restarted first, when the subject is still lost.
TEST_F(LeftBehindTest, BothEndsOfAConnectionMayBeRestarted) {
  ASSERT_NO_FATAL_FAILURE(Place({{"hearer", "a"}, {"teller", "b"}}));
  Settle();
  Lose("a");
  Lose("b");
  ComeBack("a");
  ComeBack("b");
  EXPECT_FALSE(Found("refused")) << Findings();
  Hear("assert");
  Tell("send 5");
  EXPECT_THAT(printed, HasSubstr("H in 5 "));
}

// ---- A subject that is lost while an observer asserts ready to all its subjects

// Process "a" is restarted first, so Hearer starts when its subject is still lost.
TEST_F(LeftBehindTest, AnObserverThatStartsWithoutItsSubjectIsReadyLater) {
  Data("HSTART.TXT", "");
  ASSERT_NO_FATAL_FAILURE(Place({{"hearer", "a"}, {"teller", "b"}}));
  Settle();
  Lose("a");
  Lose("b");
  ComeBack("a");
  ComeBack("b");
  Tell("send 5");
  EXPECT_THAT(printed, HasSubstr("H in 5 "));
}

// Hearer was ready for Teller and does not assert ready when it starts again.
TEST_F(LeftBehindTest, AReadyEndsWithItsObserverAlsoIfTheSubjectIsLost) {
  ASSERT_NO_FATAL_FAILURE(Place({{"hearer", "a"}, {"teller", "b"}}));
  Settle();
  Hear("assert");
  Lose("a");
  Lose("b");
  ComeBack("a");
  ComeBack("b");
  Tell("ready?");
  EXPECT_THAT(printed, HasSubstr("T any 0 ready 0 all 0"));
}

// The subject is killed when the observer is back and not connected yet.  The loss is noticed when
// the observer asks the subject for the connection.
TEST_F(LeftBehindTest, ASubjectMayBeLostWhileItsObserverIsConnected) {
  Data("HSTART.TXT", "");
  options_.say = [this](const std::string& line) {
    if (line.find("process 'a' is back") == std::string::npos) return;
    Kill("b");
    WaitUntil("its end", [&] { return HasEnded("b"); });
  };
  ASSERT_NO_FATAL_FAILURE(Place({{"hearer", "a"}, {"teller", "b"}}));
  Settle();
  Lose("a");
  ComeBack("a");
  ComeBack("b");
  EXPECT_EQ(Process("b").losses, 1);
  EXPECT_THAT(printed, Not(HasSubstr("refused"))) << "the loss is the only finding";
  Tell("send 5");
  EXPECT_THAT(printed, HasSubstr("H in 5 "));
}

TEST_F(LeftBehindTest, ASubjectMayBeLostBeforeItIsConnectedAtTheBoot) {
  Config("CONNECT.CFG", "Teller.Out.Number.S Receiver.In.Number.O\n");
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}}));
  Kill("acting");
  Settle();
  ComeBack("acting");
  Tell("send 5");
  EXPECT_THAT(receiver_->events, ElementsAre("5"));
}

// The subject is killed again as soon as it is back.  The observer asserts ready after it was
// disconnected from the first subject and before the third one is there.
TEST_F(LeftBehindTest, AReadyBetweenTwoRestartsOfTheSubjectIsKept) {
  options_.restarts = 2;
  int returns = 0;
  options_.say = [&](const std::string& line) {
    if (line.find("process 'b' is back") == std::string::npos || ++returns > 1) return;
    Post("hearer", "Command", "assert");
    Kill("b");
    WaitUntil("its end", [&] { return HasEnded("b"); });
  };
  ASSERT_NO_FATAL_FAILURE(Place({{"hearer", "a"}, {"teller", "b"}}));
  Settle();
  Lose("b");
  ComeBack("b");
  EXPECT_EQ(Process("b").losses, 2);
  Tell("send 5");
  EXPECT_THAT(printed, HasSubstr("H in 5 "));
}

// A worker whose second start never joins.
class AwayTest : public LeftBehindTest {
 protected:
  AwayTest() {
    const std::string first = root / "first";
    options_.wrapper = {
        "/bin/sh", "-c",
        "mkdir '" + first + "' 2>&- && exec \"$@\"; mkdir '" + Second() + "'; exec sleep 100",
        "sh"};
  }
  std::string Second() const { return root / "second"; }
};

TEST_F(AwayTest, AfterControlCNoRestartIsAwaitedAndTheReportNamesTheOldProcess) {
  options_.wait_ms = 5'000;
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}}));
  Settle();
  const WorkerGroup::ProcessFacts before = Process("acting");
  ASSERT_GT(before.pid, 0);
  interrupts_ = [this] { return std::filesystem::exists(Second()) ? 1 : 0; };
  Lose("acting");
  for (int i = 0; i < 10; ++i) Frame();
  EXPECT_TRUE(std::filesystem::exists(Second()));
  EXPECT_FALSE(Found("the run stops here")) << Findings();
  EXPECT_FALSE(system->powered_off());
  EXPECT_EQ(Process("acting").pid, before.pid);
  EXPECT_EQ(Process("acting").host, before.host);
}

TEST_F(AwayTest, AWorkerThatDoesNotJoinIsNamedAndGivenUp) {
  std::string said;
  options_.say = [&said](const std::string& line) { said += line + "\n"; };
  options_.wait_ms = 4'000;
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}}));
  Settle();
  Lose("acting");
  for (int i = 0; i < 10 && !system->powered_off(); ++i) Frame();
  EXPECT_THAT(said, HasSubstr("process 'acting' has not come back for 2 s: not started, stopped, "
                              "or busy; it has 4 s (--join-wait)\n"));
  EXPECT_TRUE(Found("process 'acting' did not come back within 4 s; the run stops here"))
      << Findings();
}

TEST_F(LeftBehindTest, ASecondControlCIsNoFinding) {
  ASSERT_NO_FATAL_FAILURE(Place({{"teller", "acting"}, {"hearer", "hearing"}}));
  Settle();
  interrupts_ = [] { return 2; };
  for (const char* const process : {"acting", "hearing"})
    KillProcess(Process(process).pid, SIGSTOP);
  Tell("ready?");
  EXPECT_TRUE(system->powered_off());
  system->state_hash();
  EXPECT_EQ(Findings(), "");
}

}  // namespace
}  // namespace openr_host
