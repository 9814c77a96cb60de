// Runs on two hosts, with failures of the cable between them.
#include "tests/distribution/hosts.h"

#include <gmock/gmock.h>

#include <chrono>

#include "tests/distribution/sticks.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using Clock = std::chrono::steady_clock;

// The time that docs/distribution.md states, with a margin for a busy machine; the lease is 10 s.
constexpr auto kNamedWithin = std::chrono::seconds(15);
// Shortens tests of what happens after a loss.  The lease is still longer than the 2 s after which
// a silent worker is named.
const Words kShortLease = {"--dds-lease", "4"};

class HostsTest : public testing::Test, public TwoHosts {
 protected:
  void SetUp() override {
    ConnectOrSkip();
    folder.Write("where.cfg", "Controller vision\nJointMover legs\nRCServer vision\n@vision " +
                                  std::string(kThere) + "\n");
  }

  // Starts a run with worker "legs" on its own host and "vision" on the other.
  std::unique_ptr<ProgramRun> Run(const Words& flags) {
    return StartHere(Words{"run", "--body", "ideal", "--no-panel", "--rc-port", "0", "--json",
                           "--placement", folder.File("where.cfg"), "--record", folder.File("r")} +
                     flags);
  }
  std::unique_ptr<ProgramRun> Join(const Words& flags = {}) {
    return StartThere(Words{"join", "--process", "vision"} + flags);
  }

  // EXPECTs that both programs end well and that the run is the same as in one process.
  void ExpectGood(ProgramRun* run, ProgramRun* join, const RecordedRun& one) {
    const ProgramResult& result = run->Finish();
    EXPECT_EQ(join->Finish().status, 0) << join->heard();
    ExpectSame(one, {result.status, result.err, folder.Read("r"),
                     json::parse(result.out, nullptr, false)});
  }

  const ScratchFolder folder;
};

TEST_F(HostsTest, TwoHostsAreOneRun) {
  const Words flags = {"--for", "5s"};
  const auto join = Join(), run = Run(flags + Words{"--rate", "max"});
  ExpectGood(run.get(), join.get(), Record(flags + Words{"--body", "ideal"}));
  EXPECT_GT(cable().counts().passed, 100u);
}

TEST_F(HostsTest, ABadNetworkChangesNothing) {
  cable().set_weather({.loss = 0.05, .doubling = 0.05, .delay_us = 2000, .jitter_us = 3000});
  const Words flags = {"--for", "400ms"};
  const auto join = Join(), run = Run(flags + Words{"--rate", "max"});
  ExpectGood(run.get(), join.get(), Record(flags + Words{"--body", "ideal"}));
  const Relay::Counts counts = cable().counts();
  EXPECT_GT(counts.lost, 0u);
  EXPECT_GT(counts.doubled, 0u);
  EXPECT_GT(counts.overtaken, 0u);
}

// A megabyte is sent in many packets, and some of them are lost each time.
TEST_F(HostsTest, ABadNetworkChangesNoLargeSample) {
  cable().set_weather({.loss = 0.03, .doubling = 0.03, .delay_us = 1000, .jitter_us = 1000});
  const ScratchFolder stick;
  MakeBulkStick(stick);
  folder.Write("where.cfg", "Taker1 vision\n@vision " + std::string(kThere) + "\n");
  const Words flags = {"--for", "1s", "--stick", stick.path()};
  const auto join = Join(), run = Run(flags + Words{"--rate", "max"});
  ExpectGood(run.get(), join.get(), Record(flags + Words{"--body", "ideal"}));
  EXPECT_GT(cable().counts().lost, 0u);
}

TEST_F(HostsTest, TopHearsARunOnAnotherHost) {
  const auto join = Join(), run = Run({"--for", "10min"});
  ASSERT_TRUE(run->WaitFor("state: listening"));
  const auto top = StartThere({"top", "--once", "--json"});
  const ProgramResult& result = top->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  const json runs = json::parse(result.out, nullptr, false)["runs"];
  ASSERT_EQ(runs.size(), 1u);
  ASSERT_EQ(runs[0]["processes"].size(), 2u);
  EXPECT_EQ(runs[0]["processes"][1]["pid"], join->pid());
}

TEST_F(HostsTest, AShortNetworkFailureIsNoLoss) {
  cable().set_weather({.delay_us = 2000});  // slows the run down, or it would be over too soon
  const Words flags = {"--for", "5s"};
  const auto join = Join(), run = Run(flags + Words{"--rate", "max"});
  ASSERT_TRUE(run->WaitFor("state: listening"));
  Cut();
  EXPECT_TRUE(run->WaitFor("has not answered for 2 s"));
  Mend();
  EXPECT_TRUE(run->WaitFor("process 'vision' answers again"));
  ExpectGood(run.get(), join.get(), Record(flags + Words{"--body", "ideal"}));
  EXPECT_GT(cable().counts().cut, 0u);
}

// An idle worker sends nothing but its announcements, so those must be frequent enough.
TEST_F(HostsTest, AShortNetworkFailureIsNoLossOfAnIdleWorker) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  folder.Write("where.cfg", "Trouble vision\n@vision " + std::string(kThere) + "\n");
  const Words flags = {"--for", "8s", "--stick", stick.path()}, lease = {"--dds-lease", "5"};
  const auto join = Join(lease), run = Run(flags + lease);
  ASSERT_TRUE(run->WaitFor("Trouble is running"));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // the handler has ended
  // Two failures of half the lease each, so that one of them would meet the announcement that
  // Cyclone DDS sends after four fifths of the lease.
  for (int i = 0; i < 2; ++i) {
    Cut();
    std::this_thread::sleep_for(std::chrono::milliseconds(2500));
    Mend();
    std::this_thread::sleep_for(std::chrono::milliseconds(i == 0 ? 1500 : 0));
  }
  ExpectGood(run.get(), join.get(), Record(flags + Words{"--body", "ideal"}));
}

TEST_F(HostsTest, ALongNetworkFailureEndsTheRunAndNamesProcessAndHost) {
  const auto join = Join(), run = Run({"--for", "10min"});
  ASSERT_TRUE(run->WaitFor("state: listening"));
  Cut();
  const auto begin = Clock::now();
  EXPECT_TRUE(run->WaitFor("cannot be reached any more")) << run->heard();
  EXPECT_LT(Clock::now() - begin, kNamedWithin);
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 1) << result.err;
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  const json& vision = report["processes"][1];
  EXPECT_EQ(vision["name"], "vision");
  EXPECT_THAT(vision["lost"].get<std::string>(), HasSubstr("process 'vision' (pid "));
  EXPECT_THAT(vision["lost"].get<std::string>(),
              HasSubstr(" on there) cannot be reached any more"));
  EXPECT_EQ(vision["host"], "there");
  EXPECT_EQ(report["processes"][0]["host"], "here");
  EXPECT_THAT(result.err, HasSubstr("the run stops here"));
  EXPECT_EQ(join->Finish().status, 1);
  EXPECT_THAT(join->heard(), HasSubstr("the master is gone"));
}

TEST_F(HostsTest, AFreeRunGoesOnWithoutALostHost) {
  const auto join = Join(kShortLease), run = Run(kShortLease + Words{"--free-running"});
  ASSERT_TRUE(run->WaitFor("state: listening"));
  Cut();
  ASSERT_TRUE(run->WaitFor("cannot be reached any more")) << run->heard();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  run->Signal(SIGINT);
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 1) << result.err;
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  EXPECT_EQ(report["processes"][0]["lost"], "");
  const std::string lost = report["processes"][1]["lost"];
  EXPECT_THAT(lost, HasSubstr("cannot be reached any more"));
  double lost_s = 600;
  for (const json& finding : report["findings"]) {
    if (finding["text"].get<std::string>().find(lost) == 0) lost_s = finding["time_s"];
  }
  EXPECT_GT(report["virtual_time_s"].get<double>(), lost_s + 0.2) << report["findings"];
  EXPECT_EQ(join->Finish().status, 1);
  EXPECT_THAT(join->heard(), HasSubstr("the master is gone"));
}

// Each handler in a worker takes a packet there and one back.
TEST_F(HostsTest, TheDelayOfTheNetworkIsInTheLatency) {
  cable().set_weather({.delay_us = 20'000});
  const auto join = Join(), run = Run({"--free-running"});
  ASSERT_TRUE(run->WaitFor("state: listening")) << run->heard();
  std::this_thread::sleep_for(std::chrono::seconds(1));  // so that some sensor data arrive
  run->Signal(SIGINT);
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(join->Finish().status, 0) << join->heard();
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  const json& legs = report["processes"][0];
  const json& vision = report["processes"][1];
  EXPECT_GT(vision["handlers"], 10) << report["processes"];
  EXPECT_GE(vision["handler_us"]["median"], 40'000);
  EXPECT_LT(legs["handler_us"]["median"], vision["handler_us"]["median"]);
  EXPECT_GT(cable().counts().bytes, 100 * vision["handlers"].get<uint64_t>());
}

// When its own interface is down, the sender gets an error.
TEST_F(HostsTest, APulledCableIsALostHost) {
  const auto join = Join(kShortLease), run = Run(kShortLease + Words{"--for", "10min"});
  ASSERT_TRUE(run->WaitFor("state: listening"));
  Unplug();
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr("has not answered for 2 s"));
  EXPECT_THAT(result.err, HasSubstr("cannot be reached any more"));
  EXPECT_EQ(join->Finish().status, 1);
  EXPECT_THAT(join->heard(), HasSubstr("the master is gone"));
}

}  // namespace
}  // namespace openr_host
