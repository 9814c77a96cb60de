// A lost worker is restarted, and its objects begin anew.
#include <gmock/gmock.h>
#include <signal.h>

#include <fstream>
#include <iterator>

#include "tests/distribution/hosts.h"
#include "tests/distribution/kill_process.h"
#include "tests/distribution/same_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class ReturnsTest : public testing::Test {
 protected:
  // Makes a stick with Payer, Payee and Ledger (tests/images/Coins).
  ReturnsTest() {
    stick_.Write("OPEN-R/MW/CONF/OBJECT.CFG",
                 "/MS/OPEN-R/MW/OBJS/LEDGER.BIN\n/MS/OPEN-R/MW/OBJS/PAYER.BIN\n"
                 "/MS/OPEN-R/MW/OBJS/PAYEE.BIN\n");
    stick_.Write("OPEN-R/MW/CONF/CONNECT.CFG",
                 "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S "
                 "Payer.Sensor.OSensorFrameVectorData.O\n"
                 "Payer.Coins.Coin.S Payee.Coins.Coin.O\n"
                 "Payer.Book.Entry.S Ledger.Paid.Entry.O\n"
                 "Payee.Book.Entry.S Ledger.Got.Entry.O\n");
    stick_.Write("OPEN-R/MW/OBJS/README.TXT", "");
    for (const char* const name : {"LEDGER.BIN", "PAYER.BIN", "PAYEE.BIN"})
      std::filesystem::copy_file(std::string(OPENR_IMAGES) + "/" + name, Image(name));
  }
  std::string Image(const std::string& name) const { return stick_.File("OPEN-R/MW/OBJS/" + name); }
  // AddressSanitizer ends a crashing process before the run can receive a report.
  static constexpr const char* kNoCrashes = "crashes are reported by the sanitizer";
#if defined(__SANITIZE_ADDRESS__)
  static constexpr bool kHasCrashes = false;
#else
  static constexpr bool kHasCrashes = true;
#endif
  Words OnStick(const Words& flags) const {
    return Words{"--stick", stick_.path(), "--body", "ideal"} + flags;
  }
  // Runs slowly enough for the test to act meanwhile.
  static Words RunAt(const std::string& rate, const Words& flags) {
    return Words{"run", "--no-panel", "--rc-port", "0", "--json", "--rate", rate} + flags;
  }
  // Returns the worker's process id; -1 if there is none.
  static int PidOf(const ProgramRun& run, const std::string& process) {
    // Searches for the whole words, because a folder may have the name of the process.
    const std::string words = std::string("--process") + '\0' + process + '\0';
    for (const pid_t child : ChildrenOf(run.pid())) {
      std::ifstream file("/proc/" + std::to_string(child) + "/cmdline");
      const std::string line{std::istreambuf_iterator<char>(file), {}};
      if (line.find(words) != std::string::npos) return child;
    }
    return -1;
  }
  // Replaces Payee's image by one with other code, by changing a word in it.
  void NewEdition() const {
    std::ifstream file(Image("PAYEE.BIN"), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const size_t at = bytes.find("edition one");
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, 11, "edition two");
    std::ofstream(Image("PAYEE.NEW"), std::ios::binary) << bytes;
    std::filesystem::rename(Image("PAYEE.NEW"), Image("PAYEE.BIN"));
  }

  const ScratchFolder stick_;
};

// EXPECTs a line like "got 12 twice 0 missed 0 ..." of Ledger.
void ExpectGoodBooks(const std::string& err) {
  EXPECT_THAT(err, HasSubstr(" twice 0 missed 0 "));
  EXPECT_THAT(err, Not(HasSubstr("got 0 ")));
  EXPECT_THAT(err, Not(HasSubstr("TWICE")));
  EXPECT_THAT(err, Not(HasSubstr("MISSED")));
}

const json& Process(const json& report, const std::string& name) {
  static const json none;
  for (const json& process : report["processes"]) {
    if (process["name"] == name) return process;
  }
  ADD_FAILURE() << "no process " << name << " in " << report;
  return none;
}

TEST_F(ReturnsTest, ARestartAfterACrashIsTheSameInEveryRun) {
  if (!kHasCrashes) GTEST_SKIP() << kNoCrashes;
  stick_.Write("OPEN-R/MW/DATA/P/FRAGILE.TXT", "");
  const Words flags = OnStick({"--for", "2s", "--isolate", "Payee", "--restart", "1"});
  const RecordedRun one = Record(flags);
  const RecordedRun other = Record(flags);
  EXPECT_EQ(one.status, 1) << one.err;
  EXPECT_THAT(one.err, HasSubstr("process 'Payee' is back (pid "));
  ASSERT_TRUE(one.report.is_object());
  const json& process = Process(one.report, "Payee");
  EXPECT_EQ(process["losses"], 1);
  EXPECT_EQ(process["returns"], 1);
  EXPECT_EQ(process["lost"], "");
  EXPECT_EQ(one.Hashes(), other.Hashes());
  EXPECT_EQ(one.recording, other.recording);
  EXPECT_DOUBLE_EQ(one.report["virtual_time_s"].get<double>(), 2);
}

TEST_F(ReturnsTest, TheBooksAreRightAfterwards) {
  if (!kHasCrashes) GTEST_SKIP() << kNoCrashes;
  stick_.Write("OPEN-R/MW/DATA/P/FRAGILE.TXT", "");
  ProgramRun run(RunAt("20", OnStick({"--isolate", "Payee", "--restart", "1"})));
  ASSERT_TRUE(run.WaitFor("process 'Payee' is back"));
  ASSERT_TRUE(run.WaitFor("Payee, edition one"));
  run.Signal(SIGINT);
  EXPECT_EQ(run.Finish().status, 1);
  ExpectGoodBooks(run.heard());
  EXPECT_THAT(run.heard(), HasSubstr(" lost 1 series 1"));  // coin 30 was lost in the crash
}

// A name that the lost object gave to Register() is removed.
TEST_F(ReturnsTest, ARegisteredNameEndsWithItsObject) {
  if (!kHasCrashes) GTEST_SKIP() << kNoCrashes;
  stick_.Write("OPEN-R/MW/DATA/P/FRAGILE.TXT", "");
  ProgramRun run(RunAt("20", OnStick({"--isolate", "Payee"})));
  ASSERT_TRUE(run.WaitFor("process 'Payee' (pid ")) << run.heard();
  ASSERT_TRUE(run.WaitFor("is gone; the others go on"));
  run.Signal(SIGINT);
  run.Finish();
  EXPECT_THAT(run.heard(), HasSubstr("Payee registers Purse: 0"));
  EXPECT_THAT(run.heard(), HasSubstr("Purse is gone"));
}

TEST_F(ReturnsTest, ARegisteredNameReturnsWithItsObject) {
  if (!kHasCrashes) GTEST_SKIP() << kNoCrashes;
  stick_.Write("OPEN-R/MW/DATA/P/FRAGILE.TXT", "");
  ProgramRun run(RunAt("20", OnStick({"--isolate", "Payee", "--restart", "1"})));
  ASSERT_TRUE(run.WaitFor("process 'Payee' is back"));
  ASSERT_TRUE(run.WaitFor("Payee, edition one"));
  run.Signal(SIGINT);
  run.Finish();
  const std::string& heard = run.heard();
  const std::string word = "Payee registers Purse: 0";  // status 0: the name was free again
  EXPECT_NE(heard.find(word, heard.find(word) + 1), std::string::npos) << heard;
  EXPECT_THAT(heard, HasSubstr("Purse is there"));
}

// Both objects of a worker begin anew, and their connection to each other is restored.
TEST_F(ReturnsTest, AllObjectsOfAWorkerAreRestarted) {
  if (!kHasCrashes) GTEST_SKIP() << kNoCrashes;
  stick_.Write("OPEN-R/MW/DATA/P/FRAGILE.TXT", "");
  const Words flags = OnStick({"--for", "2s", "--place", "Payer=shop", "--place", "Payee=shop"});
  const RecordedRun run = Record(flags + Words{"--restart", "9"});
  ASSERT_TRUE(run.report.is_object()) << run.err;
  EXPECT_EQ(Process(run.report, "shop")["losses"], 10) << "coin 30 of each life";
  EXPECT_EQ(Process(run.report, "shop")["returns"], 9);
  EXPECT_DOUBLE_EQ(run.report["virtual_time_s"].get<double>(), 2);
}

// Messages that arrived while the lost object had the processor go to the new object, when the
// processor is free.
TEST_F(ReturnsTest, ARestartWorksWhenHandlersTakeTime) {
  if (!kHasCrashes) GTEST_SKIP() << kNoCrashes;
  stick_.Write("OPEN-R/MW/DATA/P/FRAGILE.TXT", "");
  stick_.Write("slow.cost", "Payer * 3000\nPayee * 3000\n");
  const Words flags = OnStick({"--for", "4s", "--cost", stick_.File("slow.cost"), "--place",
                               "Payer=shop", "--place", "Payee=shop", "--restart", "2"});
  const RecordedRun one = Record(flags);
  ASSERT_TRUE(one.report.is_object()) << one.err;
  EXPECT_GE(Process(one.report, "shop")["returns"], 1);
  EXPECT_EQ(one.recording, Record(flags).recording);
}

TEST_F(ReturnsTest, AWorkerThatKeepsCrashingIsGivenUp) {
  if (!kHasCrashes) GTEST_SKIP() << kNoCrashes;
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  const RecordedRun run = Record({"--for", "1s", "--body", "ideal", "--stick", stick.path(),
                                  "--isolate", "Trouble", "--restart", "2"});
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr("process 'Trouble' is not started again: it was 2 times"));
  ASSERT_TRUE(run.report.is_object());
  EXPECT_EQ(Process(run.report, "Trouble")["losses"], 3);
  EXPECT_NE(Process(run.report, "Trouble")["lost"], "");
  EXPECT_DOUBLE_EQ(run.report["virtual_time_s"].get<double>(), 1) << "the others go on";
  const auto records = [&stick] {
    const std::string text = stick.Read("OPEN-R/EMON.LOG");
    int count = 0;
    for (size_t at = 0; (at = text.find("EXCEPTION ", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_EQ(records(), 3);
  RunProgram(kQuickly + Words{"--for", "1s", "--stick", stick.path(), "--isolate", "Trouble"});
  EXPECT_EQ(records(), 1) << "each run begins afresh";
}

TEST_F(ReturnsTest, LockstepWaitsForAKilledWorker) {
  ProgramRun run(
      RunAt("20", OnStick({"--place", "Payer=payer", "--place", "Payee=payee", "--restart", "1"})));
  ASSERT_TRUE(run.WaitFor("Payee, edition one"));
  ASSERT_NO_FATAL_FAILURE(NewEdition());
  KillProcess(PidOf(run, "payee"), SIGKILL);
  ASSERT_TRUE(run.WaitFor("process 'payee' is back")) << run.heard();
  EXPECT_TRUE(run.WaitFor("Payee, edition two")) << "new code";
  KillProcess(PidOf(run, "payee"), SIGKILL);  // the worker has used its one restart
  const ProgramResult& result = run.Finish();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err,
              HasSubstr("was killed by signal 9 (Killed); it was started again 1 times; "));
  EXPECT_THAT(result.err, HasSubstr("the run stops here"));
}

TEST_F(ReturnsTest, TheDogStandsAfterARestart) {
  ProgramRun run(RunAt("10", {"--body", "ideal", "--isolate", "JointMover", "--restart", "3"}));
  ASSERT_TRUE(run.WaitFor("state: accepting-commands"));
  const size_t before = run.heard().size();
  KillProcess(PidOf(run, "JointMover"), SIGKILL);
  ASSERT_TRUE(run.WaitFor("process 'JointMover' is back")) << run.heard();
  ASSERT_TRUE(run.WaitFor("state: accepting-commands", before)) << run.heard();
  run.Signal(SIGINT);
  const ProgramResult& result = run.Finish();
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  EXPECT_TRUE(report["robots"][0]["standing"].get<bool>());
}

TEST_F(ReturnsTest, AFreeRunGoesOnDuringARestart) {
  ProgramRun run(RunAt("1", OnStick({"--place", "Payer=payer", "--place", "Payee=payee",
                                     "--restart", "9", "--free-running"})));
  ASSERT_TRUE(run.WaitFor("Payee, edition one"));
  for (const char* const victim : {"payee", "payer", "payee"}) {
    const size_t before = run.heard().size();
    KillProcess(PidOf(run, victim), SIGKILL);
    ASSERT_TRUE(run.WaitFor(std::string("process '") + victim + "' is back", before))
        << run.heard();
  }
  run.Signal(SIGINT);
  EXPECT_EQ(run.Finish().status, 1);
  ExpectGoodBooks(run.heard());
}

// Both are lost before the run, which is stopped meanwhile, notices the first loss.  In lockstep
// Payee starts again before Payer is back.
TEST_F(ReturnsTest, CoinsArriveAfterBothEndsWereLostAtOnce) {
  for (const Words& mode : {Words{}, Words{"--free-running"}}) {
    ProgramRun run(RunAt(
        "1",
        OnStick({"--place", "Payer=payer", "--place", "Payee=payee", "--restart", "9"}) + mode));
    ASSERT_TRUE(run.WaitFor("Payer's first coin has been got")) << run.heard();
    const size_t before = run.heard().size();
    run.Signal(SIGSTOP);
    for (const char* const victim : {"payer", "payee"}) KillProcess(PidOf(run, victim), SIGKILL);
    run.Signal(SIGCONT);
    for (const char* const text :
         {"process 'payer' is back", "process 'payee' is back", "Payee has booked its first coin",
          "Payer's first coin has been got"})
      ASSERT_TRUE(run.WaitFor(text, before)) << run.heard();
    run.Signal(SIGINT);
    EXPECT_EQ(run.Finish().status, 1);
    ExpectGoodBooks(run.heard());
  }
}

TEST_F(ReturnsTest, ASecondProcessOfANameIsRefused) {
  const std::string name = RunName("second");
  stick_.Write("where.cfg", "Payee payee\n@payee 127.0.0.1\n");
  ProgramRun first({"join", "--process", "payee", "--run-name", name});
  ProgramRun run(
      RunAt("20", OnStick({"--placement", stick_.File("where.cfg"), "--run-name", name})));
  ASSERT_TRUE(run.WaitFor("Payee, edition one"));
  const ProgramResult second = RunProgram({"join", "--process", "payee", "--run-name", name});
  EXPECT_EQ(second.status, 1);
  EXPECT_THAT(second.err, HasSubstr("the run has its process 'payee' already: pid " +
                                    std::to_string(first.pid())));
  run.Signal(SIGINT);
  EXPECT_EQ(run.Finish().status, 0) << run.heard();
  EXPECT_EQ(first.Finish().status, 0) << first.heard();
}

TEST_F(ReturnsTest, AnExternalWorkerJoinsAgainByItself) {
  const std::string name = RunName("again");
  stick_.Write("where.cfg", "Payee payee\n@payee 127.0.0.1\n");
  ProgramRun join({"join", "--process", "payee", "--run-name", name, "--restart"});
  ProgramRun run(RunAt("1", OnStick({"--placement", stick_.File("where.cfg"), "--run-name", name,
                                     "--free-running"})));
  ASSERT_TRUE(run.WaitFor("Payee, edition one"));
  KillProcess(ChildrenOf(join.pid()).at(0), SIGKILL);
  EXPECT_TRUE(run.WaitFor("process 'payee' is back")) << run.heard();
  run.Signal(SIGINT);
  EXPECT_EQ(run.Finish().status, 1);
  ExpectGoodBooks(run.heard());
  EXPECT_EQ(join.Finish().status, 0) << join.heard();
}

// An external worker in lockstep is waited for only as long as --join-wait says.
TEST_F(ReturnsTest, LockstepWaitsForAnExternalWorkerOnlyForJoinWait) {
  const std::string name = RunName("chances");
  stick_.Write("where.cfg", "Payee payee\n@payee 127.0.0.1\n");
  ProgramRun join({"join", "--process", "payee", "--run-name", name});
  ProgramRun run(RunAt("20", OnStick({"--placement", stick_.File("where.cfg"), "--run-name", name,
                                      "--restart", "1", "--join-wait", "5s"})));
  ASSERT_TRUE(run.WaitFor("Payee, edition one"));
  join.Signal(SIGKILL);
  const ProgramResult& result = run.Finish();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("process 'payee' did not come back within 5 s"));
  EXPECT_THAT(result.err, HasSubstr("the run stops here"));
}

TEST_F(ReturnsTest, AWorkerThatIsRefusedDoesNotJoinAgain) {
  const std::string name = RunName("strange");
  stick_.Write("where.cfg", "Payee payee\n@payee 127.0.0.1\n");
  const ScratchFolder other;
  std::filesystem::copy(stick_.path(), other.File("stick"),
                        std::filesystem::copy_options::recursive);
  other.Write("stick/OPEN-R/NEW.TXT", "not on the other one");
  ProgramRun join({"join", "--process", "payee", "--run-name", name, "--restart", "--stick",
                   other.File("stick")});
  ProgramRun run(RunAt(
      "20", OnStick({"--placement", stick_.File("where.cfg"), "--run-name", name, "--for", "1s"})));
  ASSERT_TRUE(run.WaitFor("the run waits for another one")) << run.heard();
  EXPECT_EQ(join.Finish().status, 1) << join.heard();
  run.Signal(SIGINT);
  EXPECT_EQ(run.Finish().status, 1);
  EXPECT_THAT(join.heard(), HasSubstr("is not the stick of the run: its files differ"));
  EXPECT_THAT(join.heard(), Not(HasSubstr("another one comes")));
}

// ---- Failures of the cable between two hosts

class ReturningHostTest : public ReturnsTest, public TwoHosts {
 protected:
  void SetUp() override {
    ConnectOrSkip();
    stick_.Write("where.cfg", "Payee payee\n@payee " + std::string(kThere) + "\n");
  }
  void Start(const std::string& run_lease, const std::string& join_lease) {
    const std::string name = RunName("back");
    join_ = StartThere(
        {"join", "--process", "payee", "--run-name", name, "--restart", "--dds-lease", join_lease});
    run_ = StartHere(RunAt("1", OnStick({"--placement", stick_.File("where.cfg"), "--run-name",
                                         name, "--dds-lease", run_lease, "--free-running"})));
    ASSERT_TRUE(run_->WaitFor("Payee, edition one"));
    Cut();
    ASSERT_TRUE(run_->WaitFor("cannot be reached any more")) << run_->heard();
  }
  void ExpectToComeBack() {
    ASSERT_TRUE(run_->WaitFor("process 'payee' is back")) << run_->heard();
    run_->Signal(SIGINT);
    EXPECT_EQ(run_->Finish().status, 1);
    ExpectGoodBooks(run_->heard());
    EXPECT_EQ(join_->Finish().status, 0) << join_->heard();
  }

  std::unique_ptr<ProgramRun> join_, run_;
};

TEST_F(ReturningHostTest, AHostThatWasCutOffComesBack) {
  ASSERT_NO_FATAL_FAILURE(Start("4", "4"));
  ASSERT_TRUE(join_->WaitFor("the master is gone")) << join_->heard();
  Mend();
  ExpectToComeBack();
}

// The worker has not noticed that the run has given it up; the run tells it.
TEST_F(ReturningHostTest, AnAbandonedHostIsToldAndComesBack) {
  ASSERT_NO_FATAL_FAILURE(Start("60", "3"));
  Mend();
  EXPECT_TRUE(join_->WaitFor("the run could not reach it and goes on without"))
      << join_->heard() << run_->heard();
  ExpectToComeBack();
}

}  // namespace
}  // namespace openr_host
