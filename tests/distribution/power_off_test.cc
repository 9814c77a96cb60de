// A robot is switched off, or the run ends, while the worker of one of its objects is lost.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>

#include "distribution/worker_group.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"
#include "tests/distribution/kill_process.h"
#include "tests/distribution/sticks.h"
#include "tests/distribution/wait_until.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr int64_t kFrame_us = 8000;

class PowerOffTest : public testing::Test {
 protected:
  // Begins a run with Payee in a worker that may be restarted once.
  void Begin(int robots) {
    MakeStick(stick_, {"LEDGER.BIN", "PAYER.BIN", "PAYEE.BIN"},
              "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S "
              "Payer.Sensor.OSensorFrameVectorData.O\n"
              "Payer.Coins.Coin.S Payee.Coins.Coin.O\n"
              "Payer.Book.Entry.S Ledger.Paid.Entry.O\n"
              "Payee.Book.Entry.S Ledger.Got.Entry.O\n");
    WorkerGroupOptions options;
    options.bus.run = "power-off-" + std::to_string(getpid());
    options.placement.process_of["Payee"] = "payee";
    options.command = {OPENR_PROGRAM, "join",          "--child-of",      std::to_string(getpid()),
                       "--run-name",  options.bus.run, "--handler-limit", "0s"};
    options.stick = stick_.path();
    options.restarts = 1;
    options.say = [this](const std::string& line) { said_ += line + "\n"; };
    options.interrupts = [this] {
      ++questions_;
      return 0;
    };
    workers_ = std::make_unique<WorkerGroup>(options);
    SimulationOptions simulation;
    simulation.stick = stick_.path();
    simulation.body = "ideal";
    simulation.robots = robots;
    simulation.host_network = false;
    simulation.console = [this](std::string_view text) { printed_ += text; };
    simulation.stand_ins = [this](System* system, int robot) {
      return workers_->StandInsFor(system, robot);
    };
    simulation_ = std::make_unique<Simulation>(simulation);
    ASSERT_EQ(workers_->Connect(), "");
    system().Boot();
    Run(20);
  }
  void TearDown() override {
    if (workers_ != nullptr) workers_->End();
  }
  System& system() { return simulation_->system(); }
  Object& payee(int robot) { return *system().FindObject(robot, "Payee"); }

  // Runs frames like openr run does.
  void Run(int frames) {
    for (int i = 0; i < frames && !system().powered_off(); ++i) {
      system().RunUntil(system().now_us() + kFrame_us);
      workers_->CheckWorkers();
    }
  }
  // Kills the worker and waits until the run has noticed; returns the killed process's id.
  int64_t Kill() {
    const int64_t pid = workers_->Describe()[0].pid;
    KillProcess(pid, SIGKILL);
    WaitUntil("the loss", [this] {
      workers_->CheckWorkers();
      return workers_->Describe()[0].losses > 0;
    });
    return pid;
  }
  int StartCount() const {
    int count = 0;
    for (size_t at = 0; (at = printed_.find("Payee, edition", at)) != std::string::npos; ++at)
      ++count;
    return count;
  }

  const ScratchFolder stick_;
  std::unique_ptr<WorkerGroup> workers_;
  std::unique_ptr<Simulation> simulation_;
  std::string said_, printed_;
  int questions_ = 0;  // number of times that the workers have asked whether Ctrl-C has come
};

TEST_F(PowerOffTest, OnlyObjectsOfTheRunningRobotAreRestarted) {
  ASSERT_NO_FATAL_FAILURE(Begin(2));
  EXPECT_EQ(StartCount(), 2);
  Kill();
  system().PowerOff(0);
  Run(20);
  EXPECT_THAT(said_, HasSubstr("process 'payee' is back"));
  EXPECT_EQ(StartCount(), 3);
  const uint64_t off = payee(0).message_count(), on = payee(1).message_count();
  Run(20);
  EXPECT_EQ(payee(0).message_count(), off);
  EXPECT_GT(payee(1).message_count(), on + 100);
  ASSERT_EQ(system().findings().all().size(), 1u);
  EXPECT_THAT(system().findings().all()[0].text, HasSubstr("was killed"));
}

// The robot is off when the worker is lost, and still off when it is restarted.
TEST_F(PowerOffTest, AnObjectThatWasOffIsNotStarted) {
  ASSERT_NO_FATAL_FAILURE(Begin(2));
  system().PowerOff(1);
  Kill();
  Run(20);
  EXPECT_THAT(said_, HasSubstr("process 'payee' is back"));
  EXPECT_EQ(StartCount(), 3);
  EXPECT_TRUE(payee(1).delivery().is_off());
  EXPECT_FALSE(payee(0).delivery().is_off());
}

TEST_F(PowerOffTest, ARunThatIsOverRestartsNoWorker) {
  ASSERT_NO_FATAL_FAILURE(Begin(1));
  const int64_t pid = Kill();
  system().PowerOff(0);
  Run(20);
  workers_->CheckWorkers();
  EXPECT_EQ(workers_->Describe()[0].pid, pid) << "another one was started";
  EXPECT_THAT(said_, Not(HasSubstr("is back")));
  EXPECT_EQ(StartCount(), 1);
  EXPECT_EQ(system().findings().all().size(), 1u);
}

// The shutdown asks a lost object to stop and does not wait for its answer.
TEST_F(PowerOffTest, ARobotShutsDownWithoutItsLostObject) {
  ASSERT_NO_FATAL_FAILURE(Begin(1));
  system().Shutdown();
  Kill();
  const int64_t before_us = system().now_us();
  Run(1000);
  EXPECT_TRUE(system().powered_off());
  EXPECT_LT(system().now_us(), before_us + 100'000);
  EXPECT_THAT(said_, Not(HasSubstr("is back")));
  EXPECT_THAT(printed_, HasSubstr("got "));  // Ledger was asked to stop in the usual way
  EXPECT_EQ(system().findings().all().size(), 1u);
}

// DDS keeps a killed worker until its lease is over.  End() asks about Ctrl-C before each slice of
// a wait, so the number of questions shows that it does not wait until this worker has heard of the
// end.
TEST_F(PowerOffTest, TheEndDoesNotWaitForAKilledWorkerToHearOfIt) {
  ASSERT_NO_FATAL_FAILURE(Begin(1));
  const int64_t pid = workers_->Describe()[0].pid;
  KillProcess(pid, SIGKILL);
  siginfo_t ended;
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(pid), &ended, WEXITED | WNOWAIT), 0);
  questions_ = 0;
  workers_->End();
  EXPECT_LE(questions_, 4);
}

}  // namespace
}  // namespace openr_host
