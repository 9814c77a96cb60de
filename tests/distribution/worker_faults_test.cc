// Errors of objects in workers, and what becomes of the worker and of the run.
#include <gmock/gmock.h>
#include <signal.h>

#include "tests/distribution/hosts.h"
#include "tests/distribution/same_run.h"
#include "tests/distribution/sticks.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const Words kIdeal = {"--body", "ideal"};

// ---- A sample may have 64 MB at most

// A region of 25 MB goes to three observers.
TEST(WorkerFaultsTest, ARegionIsSentOnceForAllItsObservers) {
  const ScratchFolder stick;
  MakeBulkStick(stick);
  stick.Write("OPEN-R/MW/DATA/P/BULK.TXT", "25000000 1 1");
  const Words flags = kIdeal + Words{"--for", "1s", "--stick", stick.path()};
  ExpectSame(Record(flags), Record(flags + Isolated({"Bulk"})));
}

// Three regions of 25 MB have different bytes, so all are sent.
TEST(WorkerFaultsTest, ASampleThatIsTooLargeIsReported) {
  const ScratchFolder stick;
  MakeBulkStick(stick);
  stick.Write("OPEN-R/MW/DATA/P/BULK.TXT", "25000000 3 1");
  const ProgramResult result = RunProgram(
      kQuickly + kIdeal + Words{"--for", "1s", "--stick", stick.path(), "--isolate", "Bulk"});
  EXPECT_EQ(result.status, 1);
  const std::string words =
      "could not send 71 MB to the run, 64 MB at once is the most: an object has to notify less in "
      "one handler, or to stay in openr run";
  EXPECT_THAT(result.err, HasSubstr("openr: process 'Bulk': " + words + "\n"));
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  EXPECT_THAT(report["processes"][0]["lost"].get<std::string>(), HasSubstr(words));
}

// ---- A handler that does not return

// Mostly the watchdog finds the handler inside a call that sends to the run.  The other objects run
// until the end.
TEST(WorkerFaultsTest, AHandlerThatPrintsForEverIsNamed) {
  const ScratchFolder stick;
  stick.MakeTrouble("flood");
  const ProgramResult result =
      RunProgram(kQuickly + kIdeal +
                 Words{"--for", "1s", "--stick", stick.path(), "--isolate", "Trouble",
                       "--handler-limit", "500ms", "--console", "/dev/null"});
  EXPECT_EQ(result.status, 1);
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  EXPECT_EQ(report["virtual_time_s"], 1) << result.err;
  EXPECT_EQ(report["processes"][0]["lost"],
            "a handler does not return: DoStart (selector 1) has used more than 0.5 s of processor "
            "time (--handler-limit)");
}

// ---- An object in openr run itself ends the run

class EndingTest : public testing::Test {
 protected:
  Words RunThat(const std::string& word) {
    MakeStick(stick_, {"TAKER1.BIN", "TROUBLE.BIN"}, "");
    stick_.Write("OPEN-R/MW/DATA/P/TROUBLE.TXT", word);
    return kQuickly + kIdeal +
           Words{"--for", "1s", "--stick", stick_.path(), "--isolate", "Taker1"};
  }
  const ScratchFolder stick_;
};

TEST_F(EndingTest, TheReportOfACrashKnowsTheProcesses) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "crashes are reported by the sanitizer";
#endif
  const ProgramResult result = RunProgram(RunThat("crash"));
  EXPECT_EQ(result.status, 1);
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  EXPECT_THAT(report["error"].get<std::string>(), HasSubstr("OBJECT Trouble, DoStart"));
  ASSERT_TRUE(report.contains("processes"));
  const json& taker = report["processes"][0];
  EXPECT_EQ(taker["name"], "Taker1");
  EXPECT_EQ(taker["lost"], "");
  EXPECT_EQ(taker["handlers"], 2);
#if !defined(__SANITIZE_THREAD__)  // the heap is the sanitizer's then
  for (const json& object : report["objects"]) {
    if (object["name"] == "Taker1") {
      EXPECT_GT(object["heap_bytes_max"], 0);
    }
  }
#endif
}

// The report contains the state of the worker's objects, which a stopped worker does not send.
TEST_F(EndingTest, AStoppedProcessDoesNotCostTheReport) {
  ProgramRun run(RunThat("sayhang") + Words{"--handler-limit", "2s"});
  ASSERT_TRUE(run.WaitFor("it hangs now")) << run.heard();
  const pid_t child = ChildrenOf(run.pid()).at(0);
  kill(child, SIGSTOP);
  const ProgramResult& result = run.Finish();
  EXPECT_EQ(result.status, 1);
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.contains("processes")) << result.err;
  EXPECT_EQ(report["processes"][0]["lost"], "process 'Taker1' (pid " + std::to_string(child) +
                                                ") did not answer when the run was brought down");
  EXPECT_TRUE(report.contains("state_hash"));
}

// ---- A worker on another host

class OtherHostTest : public testing::Test, public TwoHosts {
 protected:
  // Begins a run with Trouble on the other host; Trouble does what `word` says.
  void Begin(const std::string& word, const Words& join, const Words& run) {
    if (!Connect()) GTEST_SKIP() << kNoHosts;
    stick_.MakeTrouble(word);
    stick_.Write("where.cfg", "Trouble away\n@away " + std::string(kThere) + "\n");
    join_ = StartFarAway(Words{"join", "--process", "away"} + join);
    run_ = StartHere(Words{"run", "--body", "ideal", "--no-panel", "--rc-port", "0", "--json",
                           "--stick", stick_.path(), "--placement", stick_.File("where.cfg")} +
                     run);
  }

  // The openr process that join_ has started.
  pid_t Joined() const { return ChildrenOf(join_->pid()).at(0); }

  const ScratchFolder stick_;
  std::unique_ptr<ProgramRun> join_, run_;

 private:
  // Starts openr in a PID namespace of its own, where process ids of this host mean nothing: its
  // end can be known only by its silence or its goodbye.
  static std::unique_ptr<ProgramRun> StartFarAway(const Words& arguments) {
    const char* const command =
        "exec ip netns exec \"$0\" unshare --pid --fork --mount-proc \"$@\"";
    return std::make_unique<ProgramRun>(Words{"-c", command, RunName("openr-b"), OPENR_PROGRAM} +
                                            arguments +
                                            Words{"--dds-address", kThere, "--dds-peer", kHere},
                                        "/bin/sh");
  }
};

// The packet with the crash report is lost at first.
TEST_F(OtherHostTest, ACrashReportIsSentUntilItIsReceived) {
  Begin("hang", {"--handler-limit", "4s", "--dds-lease", "60"},
        {"--for", "1s", "--dds-lease", "60"});
  if (run_ == nullptr) return;
  ASSERT_TRUE(run_->WaitFor("has not answered for 2 s")) << run_->heard();
  Cut();
  EXPECT_TRUE(join_->WaitFor("openr: a handler does not return")) << join_->heard();
  usleep(100'000);
  Mend();
  EXPECT_EQ(run_->Finish().status, 1);
  EXPECT_THAT(run_->heard(), HasSubstr("a handler does not return: DoStart (selector 1) has used"));
  EXPECT_THAT(run_->heard(), Not(HasSubstr("cannot be reached")));
}

// The worker is ended between two handlers.  Lockstep receives the goodbye at the next frame and
// need not wait for the end of the lease.
TEST_F(OtherHostTest, AnIdleWorkerThatIsEndedLeavesAtOnce) {
  Begin("nothing", {}, {"--for", "8s"});
  if (run_ == nullptr) return;
  ASSERT_TRUE(run_->WaitFor("Trouble is running")) << run_->heard();
  kill(Joined(), SIGTERM);
  EXPECT_EQ(join_->Finish().status, 128 + SIGTERM) << join_->heard();
  EXPECT_EQ(run_->Finish().status, 1);
  EXPECT_THAT(run_->heard(), HasSubstr("was ended there; the run stops here"));
  const json report = json::parse(run_->Finish().out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << run_->heard();
  EXPECT_LT(report["virtual_time_s"], 8);
}

}  // namespace
}  // namespace openr_host
