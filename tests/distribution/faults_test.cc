// Workers that are killed, stopped, never join, or are the wrong ones.
#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>
#include <sstream>

#include "tests/distribution/kill_process.h"
#include "tests/distribution/same_run.h"

namespace openr_host {
namespace {

using ::testing::ContainsRegex;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

const Words kRun = {"run", "--no-panel", "--rc-port", "0", "--body", "ideal"};

bool IsAlive(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/stat");
  std::string id, name, state;
  return status >> id >> name >> state && state != "Z" && state != "X";
}

class FaultsTest : public testing::Test {
 protected:
  // Starts a run and waits until its objects report their state.
  std::unique_ptr<ProgramRun> Start(const Words& flags) {
    auto run = std::make_unique<ProgramRun>(kRun + flags);
    EXPECT_TRUE(run->WaitFor("state: listening")) << run->Finish().err;
    return run;
  }
  // Returns the only child of the run; -1 if it has none, or more than one.
  static pid_t OnlyChildOf(const ProgramRun& run) {
    const std::vector<pid_t> children = ChildrenOf(run.pid());
    EXPECT_EQ(children.size(), 1u);
    return children.size() == 1 ? children[0] : -1;
  }
};

TEST_F(FaultsTest, AKilledProcessStopsTheRunAndIsNamed) {
  const std::unique_ptr<ProgramRun> run =
      Start({"--for", "10min", "--isolate", "JointMover", "--json"});
  const pid_t child = OnlyChildOf(*run);
  KillProcess(child, SIGKILL);
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 1) << result.err;
  const std::string words =
      "process 'JointMover' (pid " + std::to_string(child) + ") was killed by signal 9 (Killed)";
  EXPECT_THAT(result.err, HasSubstr(words));
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  EXPECT_LT(report["virtual_time_s"].get<double>(), 600);
  EXPECT_EQ(report["processes"][0]["lost"], words);
  bool found = false;
  for (const json& finding : report["findings"])
    found = found || (finding["severity"] == "error" && finding["object"] == "JointMover" &&
                      finding["text"].get<std::string>().find(words) == 0);
  EXPECT_TRUE(found) << report["findings"];
}

TEST_F(FaultsTest, ARecordingIsReplayedUpToTheLoss) {
  const ScratchFolder folder;
  const std::string file = folder.File("r");
  for (const Words& flags : {Words{}, Words{"--restart", "1"}}) {
    const std::unique_ptr<ProgramRun> run =
        Start(Words{"--for", "10min", "--isolate", "JointMover", "--record", file} + flags);
    KillProcess(OnlyChildOf(*run), SIGKILL);
    ASSERT_TRUE(run->WaitFor("was killed by signal 9")) << run->heard();
    if (!flags.empty()) {
      EXPECT_TRUE(run->WaitFor("is back")) << run->heard();
    }
    run->Signal(SIGINT);
    EXPECT_EQ(run->Finish().status, 1);
    const ProgramResult replay = RunProgram({"replay", file, "--json"});
    EXPECT_EQ(replay.status, 1);
    EXPECT_THAT(replay.err, HasSubstr(" process 'JointMover' was lost; what came then cannot be "
                                      "replayed, openr trace shows it"));
    EXPECT_THAT(replay.err, HasSubstr("s of virtual time, up to there"));
    const json answer = json::parse(replay.out, nullptr, false);
    EXPECT_EQ(answer["difference"], "");
    EXPECT_EQ(answer["problems"].size(), 1u);
    EXPECT_GT(answer["messages"], 100);
    EXPECT_THAT(RunProgram({"trace", file}).out, HasSubstr("loss: process 'JointMover' at t="));
  }
}

// The loss is reported once, with the name of the process and what the run does then.
TEST_F(FaultsTest, ALossIsReportedInOneLine) {
  for (const bool is_free : {false, true}) {
    const std::unique_ptr<ProgramRun> run =
        Start(Words{"--for", "10min", "--isolate", "JointMover"} +
              (is_free ? Words{"--free-running"} : Words{"--restart", "1"}));
    const pid_t child = OnlyChildOf(*run);
    KillProcess(child, SIGKILL);
    const std::string begin = "openr: process 'JointMover' (pid " + std::to_string(child) +
                              ") was killed by signal 9 (Killed); ";
    ASSERT_TRUE(run->WaitFor(begin)) << run->heard();
    run->Signal(SIGINT);
    run->Finish();
    const std::string& heard = run->heard();
    const size_t at = heard.find(begin) + begin.size();
    const std::string rest = heard.substr(at, heard.find('\n', at) - at);
    EXPECT_THAT(rest, EndsWith(is_free ? "the others go on" : "the run waits for it to come back"));
    EXPECT_THAT(rest, Not(HasSubstr("process")));
  }
}

// The error is the only output: there is no report of a run that did not begin.
TEST_F(FaultsTest, AMissingObjectIsTheOnlyErrorReported) {
  const Words run = kQuickly + Words{"--for", "1s", "--body", "ideal", "--isolate", "Controller"};
  const ProgramResult nobody = RunProgram(run + Words{"--place", "JointMovr=legs"});
  EXPECT_EQ(nobody.status, 1);
  EXPECT_THAT(nobody.err,
              EndsWith("openr: JointMovr is placed in process 'legs', but OBJECT.CFG names "
                       "PowerMonitor, JointMover, RCServer, Controller only; did you mean "
                       "'JointMover'?\n"));
  EXPECT_THAT(nobody.err, Not(HasSubstr("error: ")));
  EXPECT_EQ(json::parse(nobody.out, nullptr, false).size(), 1u) << nobody.out;
  const ProgramResult robot = RunProgram(run + Words{"--isolate", "OVirtualRobotComm"});
  EXPECT_EQ(robot.status, 1);
  EXPECT_THAT(robot.err, HasSubstr("openr: OVirtualRobotComm cannot be placed in process "
                                   "'OVirtualRobotComm': it is the robot's own and stays in "
                                   "openr run, with body and clock; "));
}

TEST_F(FaultsTest, TheOtherWorkersEndWithTheRun) {
  const std::unique_ptr<ProgramRun> run =
      Start({"--for", "10min", "--isolate", "JointMover", "--isolate", "Controller"});
  const std::vector<pid_t> children = ChildrenOf(run->pid());
  ASSERT_EQ(children.size(), 2u);
  KillProcess(children[0], SIGKILL);
  EXPECT_EQ(run->Finish().status, 1);
  for (const pid_t child : children) EXPECT_FALSE(IsAlive(child));
}

// The worker is named, and nothing else changes; the run waits as long as the worker is stopped.
TEST_F(FaultsTest, AStoppedProcessIsNamedAndTheRunIsTheSame) {
  const Words flags = {"--for", "3s", "--seed", "3", "--json", "--rate", "3"};
  const json alone = json::parse(RunProgram(kRun + flags).out);
  const std::unique_ptr<ProgramRun> run = Start(flags + Isolated({"JointMover"}));
  const pid_t child = OnlyChildOf(*run);
  KillProcess(child, SIGSTOP);
  EXPECT_TRUE(run->WaitFor("process 'JointMover' (pid " + std::to_string(child) +
                           ") has not answered for 2 s"));
  KillProcess(child, SIGCONT);
  EXPECT_TRUE(run->WaitFor("process 'JointMover' answers again"));
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  EXPECT_EQ(report["state_hash"], alone["state_hash"]);
  EXPECT_EQ(report["trace_hash"], alone["trace_hash"]);
}

TEST_F(FaultsTest, TheWorkersEndWithAKilledRun) {
  const std::unique_ptr<ProgramRun> run =
      Start({"--for", "10min", "--isolate", "JointMover", "--isolate", "Controller"});
  const std::vector<pid_t> children = ChildrenOf(run->pid());
  ASSERT_EQ(children.size(), 2u);
  run->Signal(SIGKILL);
  EXPECT_EQ(run->Finish().status, 128 + SIGKILL);
  for (const pid_t child : children) {
    for (int i = 0; i < 10'000 && IsAlive(child); ++i) usleep(1000);
    EXPECT_FALSE(IsAlive(child));
  }
}

TEST_F(FaultsTest, ControlCIsThePauseButtonInADistributedRun) {
  const std::unique_ptr<ProgramRun> run = Start({"--isolate", "JointMover"});
  run->Signal(SIGINT);
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("pause button pressed"));
}

TEST_F(FaultsTest, ASecondControlCEndsARunThatWaitsForAProcess) {
  const std::unique_ptr<ProgramRun> run = Start({"--isolate", "JointMover"});
  KillProcess(OnlyChildOf(*run), SIGSTOP);
  ASSERT_TRUE(run->WaitFor("has not answered for 2 s"));
  run->Signal(SIGINT);
  run->Signal(SIGTERM);  // SIGTERM counts like SIGINT; two signals of one kind could merge into one
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("error: ")));
  EXPECT_THAT(result.err, Not(HasSubstr("again to end at once")));
  // The process is stopped, so it does not receive that the run is over.
  EXPECT_THAT(result.err, HasSubstr("did not end with the run and was killed; what its objects had "
                                    "not written yet is lost"));
}

TEST_F(FaultsTest, ASecondControlCDuringTheBootIsNoFinding) {
  const ScratchFolder stick;
  stick.MakeTrouble("hang");
  ProgramRun run(kRun +
                 Words{"--stick", stick.path(), "--isolate", "Trouble", "--handler-limit", "0s"});
  ASSERT_TRUE(run.WaitFor("has not answered for 2 s")) << run.heard();
  run.Signal(SIGINT);
  run.Signal(SIGTERM);
  const ProgramResult& result = run.Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("the robot does not boot")));
}

TEST_F(FaultsTest, ControlCEndsARunThatWaitsForItsProcesses) {
  const ScratchFolder folder;
  folder.Write("where.cfg", "JointMover legs\n@legs 127.0.0.1\n");
  ProgramRun run(kRun + Words{"--placement", folder.File("where.cfg"), "--join-wait", "10s",
                              "--run-name", "early-" + std::to_string(getpid())});
  ASSERT_TRUE(run.WaitFor("waiting for process 'legs'")) << run.heard();
  run.Signal(SIGINT);
  const ProgramResult& result = run.Finish();
  EXPECT_THAT(result.err, HasSubstr("process 'legs' had not come when the run was interrupted"));
  EXPECT_THAT(result.err, Not(HasSubstr("did not come within")));
  EXPECT_THAT(result.err, Not(HasSubstr("the robot does not boot")));
}

TEST_F(FaultsTest, AnErrorInThePlacementFileIsReportedWithItsLine) {
  const ScratchFolder folder;
  folder.Write("where.cfg", "JointMover legs\nController\n");
  const ProgramResult result =
      RunProgram(kQuickly + Words{"--placement", folder.File("where.cfg")});
  EXPECT_EQ(result.status, 2) << result.err;
  EXPECT_THAT(result.err, HasSubstr("where.cfg:2: a line has two words"));
  const ProgramResult missing =
      RunProgram(kQuickly + Words{"--for", "1s", "--placement", folder.File("nothing.cfg")});
  EXPECT_NE(missing.status, 0);
  EXPECT_THAT(missing.err, HasSubstr("nothing.cfg: No such file or directory"));
}

TEST_F(FaultsTest, AFlagWithoutEffectIsRefused) {
  const ProgramResult dds = RunProgram(kQuickly + Words{"--for", "1s", "--dds-lease", "3"});
  EXPECT_EQ(dds.status, 2);
  EXPECT_THAT(dds.err, HasSubstr("--dds-lease: no object is placed in another process (--place)"));
  const ProgramResult restart =
      RunProgram(kQuickly + Words{"--for", "1s", "--restart", "3", "--monitor"});
  EXPECT_EQ(restart.status, 2);
  EXPECT_THAT(restart.err, HasSubstr("--restart: no object is placed in another process"));
  EXPECT_EQ(RunProgram(kQuickly + Words{"--for", "1s", "--body", "ideal", "--monitor", "--run-name",
                                        "spoken-of"})
                .status,
            0);
}

TEST_F(FaultsTest, AProcessThatNeverJoinsIsNamedWithAdvice) {
  const ScratchFolder folder;
  folder.Write("where.cfg", "JointMover legs\n@legs 127.0.0.1\n");
  const ProgramResult result =
      RunProgram(kQuickly + Words{"--placement", folder.File("where.cfg"), "--join-wait", "1s",
                                  "--run-name", "lonely-" + std::to_string(getpid())});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("process 'legs' did not come within 1 s"));
  const std::string advice =
      "; start it on 127.0.0.1 with: openr join --process legs --run-name lonely-";
  EXPECT_THAT(result.err, HasSubstr("waiting for process 'legs' (1 s)" + advice));
  EXPECT_THAT(result.err, HasSubstr("did not come within 1 s" + advice));
}

TEST_F(FaultsTest, ANameWithWildcardsIsRefused) {
  for (const char* const name : {"", "*", "a?", "a/b"}) {
    const ProgramResult run =
        RunProgram(kQuickly + Words{"--for", "1s", "--isolate", "JointMover", "--run-name", name});
    EXPECT_EQ(run.status, 2) << name;
    EXPECT_THAT(run.err, HasSubstr(std::string("'") + name + "' is no name for a run"));
    EXPECT_EQ(RunProgram({"join", "--process", "legs", "--run-name", name}).status, 2) << name;
  }
}

TEST_F(FaultsTest, AProcessThatFindsNoRunSaysSo) {
  const ProgramResult result = RunProgram({"join", "--process", "legs", "--wait", "500ms",
                                           "--run-name", "nobody-" + std::to_string(getpid())});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, ContainsRegex("no run 'nobody-.*' that has a place for process 'legs'"));
}

TEST_F(FaultsTest, AJoinerWithAnotherStickIsRefused) {
  const ScratchFolder folder;
  folder.Write("where.cfg", "JointMover legs\n@legs 127.0.0.1\n");
  std::filesystem::copy(OPENR_STICK, folder.File("stick"),
                        std::filesystem::copy_options::recursive);
  folder.Write("stick/OPEN-R/NEW.TXT", "not on the other one");
  const std::string name = "strange-" + std::to_string(getpid());
  ProgramRun join(
      {"join", "--process", "legs", "--run-name", name, "--stick", folder.File("stick")});
  ProgramRun run(kQuickly +
                 Words{"--for", "1s", "--placement", folder.File("where.cfg"), "--run-name", name});
  ASSERT_TRUE(run.WaitFor("the run waits for another one")) << run.heard();
  const ProgramResult& joined = join.Finish();
  EXPECT_EQ(joined.status, 1) << joined.err;
  EXPECT_THAT(joined.err, HasSubstr("is not the stick of the run: its files differ"));
  run.Signal(SIGINT);
  EXPECT_EQ(run.Finish().status, 1) << run.heard();
  EXPECT_THAT(run.heard(), HasSubstr("process 'legs' had not come when the run was interrupted"));
}

// In one process a crash stops the robot.  In a worker it does not, and the object is named.
TEST_F(FaultsTest, AnObjectThatCrashesIsNamed) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  const ProgramResult result =
      RunProgram(kQuickly + Words{"--for", "1s", "--stick", stick.path(), "--isolate", "Trouble"});
  EXPECT_EQ(result.status, 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr("process 'Trouble' (pid "));
  ASSERT_TRUE(json::accept(result.out)) << result.out;
#if !defined(__SANITIZE_ADDRESS__)  // the sanitizer reports such errors itself
  const std::string log = stick.Read("OPEN-R/EMON.LOG");
  EXPECT_THAT(log, ContainsRegex("OBJECT Trouble, DoStart .selector 1., message [0-9]+, t=0 us\n"));
  EXPECT_THAT(log, HasSubstr("STACK\n  #0 TROUBLE.BIN+0x"));
  const json finding = json::parse(result.out)["findings"].at(0);
  EXPECT_EQ(finding["object"], "Trouble");
  EXPECT_THAT(log, HasSubstr("message " + finding["message"].dump() + ","));
  EXPECT_THAT(finding["text"].get<std::string>(),
              HasSubstr(" in DoStart (selector 1), at TROUBLE.BIN+0x"));
#endif
}

TEST_F(FaultsTest, AHandlerThatDoesNotReturnIsNamed) {
  const ScratchFolder stick;
  stick.MakeTrouble("hang");
  const ProgramResult result =
      RunProgram(kQuickly + Words{"--for", "1s", "--stick", stick.path(), "--isolate", "Trouble",
                                  "--handler-limit", "500ms"});
  EXPECT_EQ(result.status, 1) << result.err;
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  EXPECT_EQ(report["virtual_time_s"], 1) << "the others go on";
  ASSERT_EQ(report["findings"].size(), 1u) << report["findings"];
  const json& finding = report["findings"][0];
  EXPECT_EQ(finding["object"], "Trouble");
  EXPECT_GT(finding["message"], 0);
  const std::string words =
      "a handler does not return: DoStart (selector 1) has used more than 0.5 s of processor time "
      "(--handler-limit)";
  EXPECT_THAT(finding["text"].get<std::string>(), HasSubstr(words));
  EXPECT_EQ(report["processes"][0]["lost"], words);
  EXPECT_THAT(result.err, HasSubstr("a handler does not return: Trouble, DoStart (selector 1), "
                                    "message " +
                                    finding["message"].dump() + ", t=0 us; "));
}

TEST_F(FaultsTest, AnImageThatCannotBeLoadedIsNamed) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  stick.Write("OPEN-R/MW/OBJS/TROUBLE.BIN", "not an image");
  const ProgramResult result =
      RunProgram(kQuickly + Words{"--for", "1s", "--stick", stick.path(), "--isolate", "Trouble"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("TROUBLE.BIN"));
}

}  // namespace
}  // namespace openr_host
