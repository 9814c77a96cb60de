// In a free run the wall clock does not wait: not for a run that cannot keep up with it, and not
// for a stopped worker.
#include <gmock/gmock.h>
#include <signal.h>

#include "distribution/worker_group.h"
#include "runtime/core/api.h"
#include "runtime/core/load_stick.h"
#include "tests/conformance/conform_fixture.h"
#include "tests/distribution/hosts.h"
#include "tests/distribution/same_run.h"
#include "tests/runtime/core/probe.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

// At this rate a second of the wall clock is more virtual time than DoInit or the run can use.
TEST(FreeClockTest, ARunThatCannotKeepUpHearsItsProcesses) {
  const ProgramResult result =
      RunProgram(Words{"run", "--rate", "1000", "--for", "200s", "--body", "ideal", "--no-panel",
                       "--rc-port", "0", "--json", "--free-running"} +
                 Isolated({"JointMover", "RCServer"}));
  EXPECT_EQ(result.status, 0) << result.err;
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_EQ(report["processes"].size(), 2u) << result.out;
  for (const json& process : report["processes"]) EXPECT_GT(process["handlers"], 5);
  EXPECT_THAT(result.err, HasSubstr("state: gains"));
}

// A free run with Teller and Hearer in one worker.
class FreeWorkerGroupTest : public ConformTest {
 protected:
  FreeWorkerGroupTest() {
    Config("CONNECT.CFG", "Sender.Out.Number.S Hearer.In.Number.O\n");
    options_.bus.run = RunName("free");
    options_.stick = root;
    options_.is_free = true;
    options_.say = [](const std::string&) {};
    options_.command = {OPENR_PROGRAM, "join",          "--child-of", std::to_string(getpid()),
                        "--run-name",  options_.bus.run};
    options_.placement.process_of = {{"teller", "both"}, {"hearer", "both"}};
    workers_ = std::make_unique<WorkerGroup>(options_);
    SystemOptions options;
    options.console = [this](std::string_view text) { printed += text; };
    system = std::make_unique<System>(std::move(options));
    system->AddRobot("ERS-210", stick);
    sender_ = system->AddObject<SubjectProbe>(0, "sender");
  }
  ~FreeWorkerGroupTest() override { workers_->End(); }

  void SwitchOn() {
    ASSERT_TRUE(LoadStick(system.get(), 0, workers_->StandInsFor(system.get(), 0)));
    ASSERT_EQ(workers_->Connect(), "");
    system->Boot();
  }
  // Lets virtual time pass as fast as it can until `done`.  Returns false if that takes too long.
  template <typename Done>
  bool PumpUntil(const Done& done) {
    for (int i = 0; i < 100'000 && !done(); ++i) {
      Settle();
      workers_->Pump(1000);
    }
    return done();
  }
  void SendBytes(size_t size) {
    RunAs(sender_, [&] {
      auto* const region = new RCRegion(size);
      sender_->out->SetData(region);
      region->RemoveReference();
      sender_->out->NotifyObservers();
    });
  }
  WorkerGroup::ProcessFacts Process() const { return workers_->Describe().at(0); }

  WorkerGroupOptions options_;
  std::unique_ptr<WorkerGroup> workers_;
  SubjectProbe* sender_ = nullptr;
};

// A DoInit may take long to load a model, for instance.
TEST_F(FreeWorkerGroupTest, ADoInitInAWorkerMayTakeLong) {
  ASSERT_NO_FATAL_FAILURE(SwitchOn());
  system->RunFor(int64_t{3600} * 1'000'000);
  ASSERT_TRUE(PumpUntil([&] { return system->booted(); }));
  Hear("assert");
  EXPECT_TRUE(PumpUntil([&] { return sender_->out->IsReady() != 0; }));
  EXPECT_EQ(Findings(), "");
}

TEST_F(FreeWorkerGroupTest, AStoppedWorkerDelaysNoOtherObject) {
  ASSERT_NO_FATAL_FAILURE(SwitchOn());
  ASSERT_TRUE(PumpUntil([&] { return system->booted(); })) << Findings();
  Hear("assert");
  ASSERT_TRUE(PumpUntil([&] { return sender_->out->IsReady() != 0; }));
  const auto pid = static_cast<pid_t>(Process().pid);
  ASSERT_GT(pid, 1);
  kill(pid, SIGSTOP);
  SendBytes(1 << 20);
  Settle();
  printed.clear();
  Tell("ready?");
  Settle();
  EXPECT_EQ(Process().lost, "");
  kill(pid, SIGCONT);
  EXPECT_TRUE(PumpUntil([&] { return !printed.empty(); })) << Findings();
  EXPECT_EQ(Findings(), "");
}

TEST_F(FreeWorkerGroupTest, MessagesInAKilledWorkerAreCountedAsLost) {
  ASSERT_NO_FATAL_FAILURE(SwitchOn());
  ASSERT_TRUE(PumpUntil([&] { return system->booted(); })) << Findings();
  const auto pid = static_cast<pid_t>(Process().pid);
  ASSERT_GT(pid, 1);
  kill(pid, SIGSTOP);
  Tell("ready?");
  Settle();
  kill(pid, SIGKILL);
  EXPECT_TRUE(PumpUntil([&] { return Process().losses > 0; }));
  EXPECT_TRUE(Found("; 1 messages that it had been handed are lost")) << Findings();
  Tell("ready?");
  Settle();
  workers_->ReportLosses();
  EXPECT_TRUE(Found("messages came after process 'both' was gone; nobody heard them"))
      << Findings();
}

}  // namespace
}  // namespace openr_host
