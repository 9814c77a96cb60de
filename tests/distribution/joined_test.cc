// External workers that are killed, stopped, ended by their user, or have another stick.
#include <gmock/gmock.h>
#include <signal.h>

#include <tuple>

#include "distribution/process_slot.h"
#include "tests/distribution/hosts.h"
#include "tests/distribution/kill_process.h"
#include "tests/distribution/same_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class JoinedTest : public testing::Test {
 protected:
  JoinedTest() { folder_.Write("where.cfg", "Controller vision\n@vision 127.0.0.1\n"); }

  std::unique_ptr<ProgramRun> Run(const Words& flags) const {
    return std::make_unique<ProgramRun>(Words{"run", "--no-panel", "--rc-port", "0", "--body",
                                              "ideal", "--placement", folder_.File("where.cfg"),
                                              "--run-name", name_} +
                                        flags);
  }
  std::unique_ptr<ProgramRun> Join(const Words& flags = {}) const {
    return std::make_unique<ProgramRun>(Words{"join", "--process", "vision", "--run-name", name_} +
                                        flags);
  }
  // The message about a loss that is noticed by the lease only, after 10 s.
  static constexpr const char* kLate = "cannot be reached any more";

  inline static const Words kShortLease = {"--dds-lease", "4"};

  const ScratchFolder folder_;
  const std::string name_ = RunName(testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(JoinedTest, AKilledWorkerIsNoticedAtOnceAndJoinsAgain) {
  const auto join = Join({"--restart"});
  const auto run = Run({"--free-running"});
  ASSERT_TRUE(run->WaitFor("state: listening"));
  const pid_t child = ChildrenOf(join->pid()).at(0);
  KillProcess(child, SIGKILL);
  EXPECT_TRUE(run->WaitFor("process 'vision' is back")) << run->heard();
  EXPECT_THAT(run->heard(), HasSubstr("process 'vision' (pid " + std::to_string(child) + " on " +
                                      HostName() + ") is not there any more: killed, or ended"));
  run->Signal(SIGINT);
  EXPECT_EQ(run->Finish().status, 1);
  EXPECT_THAT(run->heard(), Not(HasSubstr(kLate)));
  EXPECT_EQ(join->Finish().status, 0) << join->heard();
}

TEST_F(JoinedTest, AKilledWorkerStopsLockstepAtOnce) {
  const auto join = Join();
  const auto run = Run({});
  ASSERT_TRUE(run->WaitFor("state: listening"));
  join->Signal(SIGKILL);
  EXPECT_EQ(run->Finish().status, 1);
  EXPECT_THAT(run->heard(), HasSubstr("is not there any more: killed, or ended"));
  EXPECT_THAT(run->heard(), HasSubstr("the run stops here"));
}

// A killed run cannot tell its worker that it is over.
TEST_F(JoinedTest, AWorkerWithoutItsMasterEnds) {
  const auto join = Join(kShortLease);
  const auto run = Run(kShortLease);
  ASSERT_TRUE(run->WaitFor("state: listening"));
  run->Signal(SIGKILL);
  EXPECT_EQ(join->Finish().status, 1);
  EXPECT_THAT(join->heard(), HasSubstr("the master is gone"));
}

TEST_F(JoinedTest, AWorkerWithoutItsMasterWaitsForTheNextRun) {
  const auto join = Join(kShortLease + Words{"--restart"});
  const auto run = Run(kShortLease);
  ASSERT_TRUE(run->WaitFor("state: listening"));
  run->Signal(SIGKILL);
  ASSERT_TRUE(join->WaitFor("the master is gone")) << join->heard();
  const auto next = Run(kShortLease);
  ASSERT_TRUE(next->WaitFor("state: listening")) << next->heard();
  EXPECT_TRUE(join->WaitFor("has joined run '" + name_ + "' (pid " + std::to_string(next->pid())))
      << join->heard();
  next->Signal(SIGINT);
  EXPECT_EQ(next->Finish().status, 0) << next->heard();
  EXPECT_EQ(join->Finish().status, 0) << join->heard();
}

TEST_F(JoinedTest, AWorkerSaysWhichRunItHasJoined) {
  const auto join = Join();
  const auto run = Run({});
  EXPECT_TRUE(join->WaitFor("openr: process 'vision': has joined run '" + name_ + "' (pid " +
                            std::to_string(run->pid()) + " on " + HostName() +
                            ") with Controller\n"))
      << join->heard();
  EXPECT_TRUE(run->WaitFor("state: listening"));
  EXPECT_THAT(run->heard(), Not(HasSubstr("has joined")));
}

TEST_F(JoinedTest, AWorkerSaysWhyTheRunEnded) {
  const auto join = Join();
  const auto run = Run({});
  ASSERT_TRUE(run->WaitFor("state: listening")) << run->heard();
  run->Signal(SIGINT);
  EXPECT_EQ(run->Finish().status, 0) << run->heard();
  EXPECT_EQ(join->Finish().status, 0) << join->heard();
  EXPECT_THAT(join->heard(), HasSubstr("openr: process 'vision': the run is over, ended by pause: "
                                       "PowerMonitor shut the robot down after the pause button"));
}

TEST_F(JoinedTest, ALostWorkerEndsTheRunAndIsReported) {
  const auto join = Join();
  const auto run = Run({"--report", folder_.File("r.json")});
  ASSERT_TRUE(run->WaitFor("state: listening")) << run->heard();
  join->Signal(SIGKILL);
  EXPECT_EQ(run->Finish().status, 1);
  EXPECT_THAT(run->heard(), HasSubstr("\nended by lost-process: process 'vision'"));
  EXPECT_THAT(folder_.Read("r.json"), HasSubstr("\"ended_by\": \"lost-process\""));
}

TEST_F(JoinedTest, ASecondRunOfTheNameGivesWay) {
  const auto first = Run({});  // waits for its worker
  ASSERT_TRUE(first->WaitFor("waiting for process 'vision'"));
  const auto begun = [&] {
    return "there is a run of the name '" + name_ + "' already (pid " +
           std::to_string(first->pid()) + " on " + HostName() + ")";
  };
  const auto second = Run({});
  EXPECT_EQ(second->Finish().status, 1);
  EXPECT_THAT(second->heard(), HasSubstr(begun()));
  const auto join = Join();
  ASSERT_TRUE(first->WaitFor("state: listening")) << first->heard();
  const auto third = Run({});  // the first run has begun now
  EXPECT_EQ(third->Finish().status, 1);
  EXPECT_THAT(third->heard(), HasSubstr(begun()));
  first->Signal(SIGINT);
  EXPECT_EQ(first->Finish().status, 0) << first->heard();
  EXPECT_EQ(join->Finish().status, 0) << join->heard();
}

// The master cannot read the stick on which the crash record is.
TEST_F(JoinedTest, ACrashSaysWhereItsRecordIs) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "crashes are reported by the sanitizer";
#endif
  const ScratchFolder stick, copy;
  stick.MakeTrouble("crash");
  copy.MakeTrouble("crash");
  folder_.Write("where.cfg", "Trouble vision\n@vision 127.0.0.1\n");
  const auto join = Join({"--stick", copy.path()});
  const auto run = Run({"--stick", stick.path(), "--for", "1s"});
  EXPECT_EQ(run->Finish().status, 1);
  EXPECT_THAT(run->heard(),
              HasSubstr("; record: " + copy.File("OPEN-R/EMON.LOG") + " on " + HostName() + "; "));
  EXPECT_NE(copy.Read("OPEN-R/EMON.LOG"), "");
  EXPECT_EQ(stick.Read("OPEN-R/EMON.LOG"), "");
}

// The run cannot begin without the object, and says why in its report.
TEST_F(JoinedTest, AConstructorThatEndsTheWorkerIsReportedByTheRun) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "crashes are reported by the sanitizer";
#endif
  const std::tuple<const char*, const char*, Words> faults[] = {
      {"earlycrash", "crash: SIGSEGV", {}},
      {"earlycrash", "crash: SIGSEGV", {"--strict"}},
      {"earlyabort", "crash: a constructor of a global object has called abort()", {}},
      {"earlyexit", "crash: a constructor of a global object has called exit()", {}},
      {"earlyhang", "the loading or unloading of an image does not end: constructors of its", {}}};
  for (const auto& [word, text, flags] : faults) {
    SCOPED_TRACE(word);
    const ScratchFolder stick;
    stick.MakeTrouble(word);
    folder_.Write("where.cfg", "Trouble vision\n@vision 127.0.0.1\n");
    const auto join = Join({"--handler-limit", "200ms"});
    const std::string pid = std::to_string(join->pid());
    const auto run = Run(Words{"--stick", stick.path(), "--for", "1s", "--json"} + flags);
    EXPECT_EQ(run->Finish().status, 1);
    EXPECT_THAT(run->heard(), HasSubstr(std::string("\nended by no-boot: Trouble: ") + text));
    const json report = json::parse(run->said(), nullptr, false);
    ASSERT_TRUE(report.is_object()) << run->heard();
    EXPECT_EQ(report["findings"].size(), 1u);
    EXPECT_EQ(report["findings"].at(0)["object"], "Trouble");
    const auto finding = report["findings"].at(0)["text"].get<std::string>();
    EXPECT_THAT(finding, HasSubstr(text));
    EXPECT_THAT(finding, HasSubstr("; process 'vision' (pid " + pid + ") is gone"));
    EXPECT_EQ(report["processes"][0]["lost"], finding);
    EXPECT_EQ(join->Finish().status, 1);
    EXPECT_THAT(join->heard(), HasSubstr("Trouble, constructors of its globals"));
    EXPECT_THAT(join->heard(), Not(HasSubstr("ended by ")));
  }
}

TEST_F(JoinedTest, AWorkerThatIsEndedTellsTheRun) {
  const auto join = Join();
  const auto run = Run({});
  ASSERT_TRUE(run->WaitFor("state: listening"));
  const std::string words = "process 'vision' (pid " + std::to_string(join->pid()) + " on " +
                            HostName() + ") was ended there; the run stops here";
  join->Signal(SIGTERM);
  EXPECT_EQ(run->Finish().status, 1);
  EXPECT_THAT(run->heard(), HasSubstr(words));
  EXPECT_EQ(join->Finish().status, 128 + SIGTERM) << join->heard();
}

TEST_F(JoinedTest, AWorkerTakesTheSlotOfOneThatWasEnded) {
  const auto first = Join({"--restart"});
  const auto run = Run({"--free-running"});
  ASSERT_TRUE(run->WaitFor("state: listening"));
  const auto second = Join({"--restart"});
  ASSERT_TRUE(second->WaitFor("the run has its process 'vision' already: pid " +
                              std::to_string(ChildrenOf(first->pid()).at(0))));
  ASSERT_TRUE(second->WaitFor("this one waits until it is gone"));
  first->Signal(SIGINT);
  EXPECT_EQ(first->Finish().status, 128 + SIGINT) << first->heard();
  EXPECT_TRUE(run->WaitFor("was ended there; ")) << run->heard();
  EXPECT_TRUE(run->WaitFor("process 'vision' is back")) << run->heard();
  run->Signal(SIGINT);
  EXPECT_EQ(run->Finish().status, 1);
  EXPECT_EQ(second->Finish().status, 0) << second->heard();
}

TEST_F(JoinedTest, AStoppedWorkerIsNamedInAFreeRun) {
  const auto join = Join();
  const auto run = Run({"--free-running"});
  ASSERT_TRUE(run->WaitFor("state: listening"));
  join->Signal(SIGSTOP);
  EXPECT_TRUE(run->WaitFor("process 'vision' (pid " + std::to_string(join->pid()) +
                           ") has not answered for 2 s: stopped, or busy; the others go on"))
      << run->heard();
  join->Signal(SIGCONT);
  EXPECT_TRUE(run->WaitFor("process 'vision' answers again"));
  run->Signal(SIGINT);
  EXPECT_EQ(run->Finish().status, 0) << run->heard();
  EXPECT_EQ(join->Finish().status, 0) << join->heard();
}

TEST_F(JoinedTest, AfterAWorkerWithAnotherStickTheRunWaitsForTheRightOne) {
  std::filesystem::copy(OPENR_STICK, folder_.File("other"),
                        std::filesystem::copy_options::recursive);
  folder_.Write("other/OPEN-R/NEW.TXT", "not on the other one");
  const auto wrong = Join({"--stick", folder_.File("other")});
  const auto run = Run({"--for", "1s"});
  EXPECT_EQ(wrong->Finish().status, 1);
  EXPECT_THAT(wrong->heard(), HasSubstr("is not the stick of the run"));
  ASSERT_TRUE(run->WaitFor("the run waits for another one")) << run->heard();
  EXPECT_THAT(run->heard(), HasSubstr("process 'vision' (pid "));
  EXPECT_THAT(run->heard(), HasSubstr("is not the stick of the run: its files differ"));
  const auto right = Join();
  EXPECT_EQ(run->Finish().status, 0) << run->heard();
  EXPECT_EQ(right->Finish().status, 0) << right->heard();
}

TEST_F(JoinedTest, AFolderThatIsNotThereNeedsNoRun) {
  const auto join = Join({"--stick", folder_.File("nowhere"), "--wait", "1h"});
  EXPECT_NE(join->Finish().status, 0);
  EXPECT_THAT(join->heard(), HasSubstr("nowhere: there is no such folder"));
}

}  // namespace
}  // namespace openr_host
