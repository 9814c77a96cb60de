// openr join --restart: after which errors it tries again.
#include <gmock/gmock.h>
#include <signal.h>

#include "distribution/bus.h"
#include "distribution/process_slot.h"
#include "tests/distribution/hosts.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

int CountOf(const std::string& text, const std::string& in) {
  int count = 0;
  for (size_t at = in.find(text); at != std::string::npos; at = in.find(text, at + 1)) ++count;
  return count;
}

class JoinRestartTest : public testing::Test, public TwoHosts {
 protected:
  // Sets the interface of the other host "up" or "down".
  static void SetThere(const std::string& state) {
    const std::string command = "ip -n " + RunName("openr-b") + " link set cable " + state;
    EXPECT_EQ(std::system(command.c_str()), 0);
  }
  std::unique_ptr<ProgramRun> Run(const Words& flags) {
    folder_.Write("where.cfg", "Controller vision\n@vision " + std::string(kThere) + "\n");
    return StartHere(Words{"run", "--body", "ideal", "--no-panel", "--rc-port", "0", "--placement",
                           folder_.File("where.cfg"), "--dds-lease", "2"} +
                     flags);
  }
  const ScratchFolder folder_;
};

TEST_F(JoinRestartTest, AWorkerJoinsAgainWhenItsInterfaceReturns) {
  if (!Connect()) GTEST_SKIP() << kNoHosts;
  const auto join = StartThere({"join", "--process", "vision", "--restart", "--dds-lease", "2"});
  const auto first = Run({"--for", "10min"});
  ASSERT_TRUE(first->WaitFor("state: listening")) << first->heard();
  SetThere("down");
  EXPECT_EQ(first->Finish().status, 1) << first->heard();
  const std::string words = "openr: process 'vision': tries again until it can\n";
  ASSERT_TRUE(join->WaitFor(words)) << join->heard();
  EXPECT_THAT(join->heard(), HasSubstr("the master is gone"));
  sleep(3);  // for some attempts to fail
  SetThere("up");
  const auto second = Run({"--for", "100ms"});
  EXPECT_EQ(second->Finish().status, 0) << second->heard();
  EXPECT_EQ(join->Finish().status, 0) << join->heard();
  EXPECT_EQ(CountOf(words, join->heard()), 1);
  EXPECT_EQ(CountOf("does not match an available interface", join->heard()), 1);
  EXPECT_EQ(CountOf("has joined run", join->heard()), 2);
}

TEST(JoinRestartFlagTest, AnAddressThatIsNotOfThisHostIsRefusedAtOnce) {
  const ProgramResult result =
      RunProgram({"join", "--process", "vision", "--restart", "--dds-address", "192.0.2.1"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("openr: Cyclone DDS: domain: "));
  EXPECT_THAT(result.err, Not(HasSubstr("tries again")));
}

// The test plays the master.
TEST(JoinRestartFlagTest, AnInvalidSampleOfAMasterDoesNotEndJoin) {
  BusOptions options;
  options.run = RunName("amiss");
  Bus bus(options);
  ProcessSlot slot(&bus, "victim", false);
  slot.OpenSession("now");
  ProgramRun join(
      {"join", "--process", "victim", "--session", "now", "--run-name", options.run, "--restart"});
  while (!slot.AwaitJoin(10)) {
  }
  openr_wire_ToWorker to_worker{};
  WireArena arena;
  to_worker.body._d = openr_wire_TO_WORKER_WELCOME;
  to_worker.body._u.welcome.version = openr_wire_VERSION;
  to_worker.body._u.welcome.stick = arena.Text(OPENR_STICK);
  slot.channel()->Send(to_worker);
  to_worker.body = {};
  to_worker.body._d = openr_wire_TO_WORKER_DELIVER;
  to_worker.body._u.deliver.message.target = 4242;
  slot.channel()->Send(to_worker);
  EXPECT_TRUE(join.WaitFor("has ended; another one comes")) << join.heard();
  EXPECT_THAT(join.heard(),
              HasSubstr("process 'victim': a message to an object that is not there"));
  const auto left = slot.channel()->Receive(1000);
  ASSERT_TRUE(left);
  ASSERT_EQ(left->body._d, openr_wire_TO_MASTER_GOODBYE);
  EXPECT_STREQ(left->body._u.goodbye.text,
               "could not go on: a message to an object that is not there");
  join.Signal(SIGTERM);
  EXPECT_EQ(join.Finish().status, 128 + SIGTERM);
}

}  // namespace
}  // namespace openr_host
