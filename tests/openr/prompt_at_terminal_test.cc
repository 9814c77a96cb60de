// The prompts of openr replay --step and openr attach at a terminal: editing, history, completion.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "runtime/base/temp_folder.h"
#include "tests/openr/program_run.h"
#include "tests/openr/terminal_run.h"

namespace openr_host {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr char kUp[] = "\x1b[A", kLeft[] = "\x1b[D", kCtrlC[] = "\x03", kCtrlD[] = "\x04";

// Returns the number of processes of the session `session`.
int ProcessesOf(pid_t session) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const pid_t process = std::atoi(entry.path().filename().c_str());
    count += process > 0 && getsid(process) == session;
  }
  return count;
}

class PromptAtTerminalTest : public testing::Test {
 protected:
  PromptAtTerminalTest() {
    setenv("TERM", "xterm", 1);
    setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1);
  }
  ~PromptAtTerminalTest() override { unsetenv("XDG_RUNTIME_DIR"); }

  // Records a run of the virtual time `length`, and returns its file.
  std::string Record(const std::string& length = "2s") const {
    const std::string file = folder_.path() + "/run.rec";
    const ProgramResult run = RunProgram({"run", "--body", "ideal", "--for", length, "--rate",
                                          "max", "--no-panel", "--rc-port", "0", "--record", file});
    EXPECT_EQ(run.status, 0) << run.err;
    return file;
  }

  const TempFolder folder_;
};

TEST_F(PromptAtTerminalTest, EditsALineAndRecallsItByArrowUp) {
  TerminalRun step({"replay", Record(), "--step"}, "(");
  ASSERT_TRUE(step.WaitFor("(start) ")) << step.shown();
  EXPECT_NE(step.Ask("stp 7" + std::string(kLeft) + kLeft + kLeft + "e\r", "t=0"), "")
      << step.shown();
  EXPECT_NE(step.Ask("print hsh" + std::string(kLeft) + kLeft + "a\r", "trace "), "")
      << step.shown();
  EXPECT_NE(step.Ask(kUp + std::string("\r"), "trace "), "") << step.shown();
  step.Type(kCtrlD);
  EXPECT_EQ(step.Finish(), 0) << step.shown();
  EXPECT_THAT(step.shown(), Not(HasSubstr("no command")));
  EXPECT_TRUE(step.IsAsBefore());
}

TEST_F(PromptAtTerminalTest, TabCompletesVerbsNamesAndQuantities) {
  TerminalRun step({"replay", Record(), "--step"}, "(");
  ASSERT_TRUE(step.WaitFor("(start) ")) << step.shown();
  EXPECT_THAT(step.Ask("goto 1s\r", "t=1.000000"), HasSubstr("(message ")) << step.shown();
  EXPECT_NE(step.Ask("pr\tha\t\r", "trace "), "") << step.shown();
  EXPECT_NE(step.Ask("break ob\tJoint\t\r", "break 1\r\n"), "") << step.shown();
  EXPECT_NE(step.Ask("break ser\tMoverC\t\r", "break 2\r\n"), "") << step.shown();
  EXPECT_NE(step.Ask("p heig\t\r", "height_mm is "), "") << step.shown();
  EXPECT_NE(step.Ask("p objects.JointM\tst\t\r", "objects.JointMover.state is "), "")
      << step.shown();
  EXPECT_NE(step.Ask("p rob\tpit\t\r", "robots[0].pitch_deg is "), "") << step.shown();
  EXPECT_NE(step.Ask("break when robots[0].objects.JointM\tsta\t== x\r", "break 3\r\n"), "")
      << step.shown();
  // Two verbs begin so: the second Tab shows them.
  step.Type("br\t\t");
  EXPECT_TRUE(step.WaitFor("break   breaks\r\n")) << step.shown();
  EXPECT_NE(step.Ask(kCtrlC, "^C\r\n"), "");
  step.Type(kCtrlD);
  EXPECT_EQ(step.Finish(), 0) << step.shown();
}

TEST_F(PromptAtTerminalTest, CtrlCDropsTheLineAndCtrlDEnds) {
  TerminalRun step({"replay", Record(), "--step"}, "(");
  ASSERT_TRUE(step.WaitFor("(start) ")) << step.shown();
  EXPECT_NE(step.Ask("nonsense" + std::string(kCtrlC), "^C\r\n"), "") << step.shown();
  EXPECT_NE(step.Ask("step\r", "t="), "");
  step.Type(kCtrlD);
  EXPECT_EQ(step.Finish(), 0) << step.shown();
  EXPECT_THAT(step.shown(), Not(HasSubstr("no command")));
  EXPECT_TRUE(step.IsAsBefore());
}

TEST_F(PromptAtTerminalTest, GoingBackKeepsTheHistory) {
  TerminalRun step({"replay", Record(), "--step"}, "(");
  ASSERT_TRUE(step.WaitFor("(start) ")) << step.shown();
  EXPECT_NE(step.Ask("step 1500\r", "t="), "");  // beyond a snapshot: another process goes on
  EXPECT_NE(step.Ask("print hash\r", "trace "), "") << step.shown();
  EXPECT_NE(step.Ask("back 5\r", "t="), "") << step.shown();
  EXPECT_NE(step.Ask("back 700\r", "t="), "") << step.shown();  // before the snapshot
  // Up to "back 700", "back 5", "print hash".
  EXPECT_NE(step.Ask(std::string(kUp) + kUp + kUp + "\r", "trace "), "") << step.shown();
  step.Type("quit\r");
  EXPECT_EQ(step.Finish(), 0) << step.shown();
}

// The processes are snapshots, one after each 1000 messages, of which old ones are thinned out.
TEST_F(PromptAtTerminalTest, AfterALongWaySomeDozenProcessesAreLeftAndGoingBackEndsThem) {
  TerminalRun step({"replay", Record("150s"), "--step"}, "(");
  ASSERT_TRUE(step.WaitFor("(start) ")) << step.shown();
  EXPECT_NE(step.Ask("step 50000\r", "t="), "") << step.shown();
  const int count = ProcessesOf(step.pid());
  EXPECT_GT(count, 10);
  EXPECT_LT(count, 40);
  EXPECT_NE(step.Ask("back 49500\r", "t="), "") << step.shown();
  EXPECT_EQ(ProcessesOf(step.pid()), 2);  // the snapshot of the start, and its copy
  step.Type("quit\r");
  EXPECT_EQ(step.Finish(), 0) << step.shown();
}

TEST_F(PromptAtTerminalTest, ASignalThatEndsTheSessionRestoresTheTerminal) {
  ProgramRun run({"run", "--rc-port", "0", "--body", "ideal", "--no-panel", "--run-name", "alive"});
  ASSERT_TRUE(run.WaitFor("remote control: "));
  TerminalRun attach({"attach", "alive"}, "alive> ");
  ASSERT_TRUE(attach.WaitFor("alive> ")) << attach.shown();
  kill(attach.pid(), SIGTERM);
  EXPECT_EQ(attach.Finish(), 128 + SIGTERM) << attach.shown();
  EXPECT_TRUE(attach.IsAsBefore());
}

TEST_F(PromptAtTerminalTest, TheConsoleOfARunCompletesWhatTheRunKnows) {
  ProgramRun run({"run", "--rc-port", "0", "--body", "ideal", "--no-panel", "--run-name", "alive"});
  ASSERT_TRUE(run.WaitFor("remote control: "));
  TerminalRun attach({"attach", "alive"}, "alive> ");
  ASSERT_TRUE(attach.WaitFor("alive> ")) << attach.shown();
  EXPECT_NE(attach.Ask("statu\t\r", " messages, "), "") << attach.shown();
  EXPECT_NE(attach.Ask("object RCS\t\r", "RCServer: "), "") << attach.shown();
  EXPECT_NE(attach.Ask("press chi\tfo\t24ms\r", "press chin for 24ms\r\n"), "") << attach.shown();
  EXPECT_NE(attach.Ask(std::string(kUp) + kUp + "\r", "RCServer: "), "") << attach.shown();
  EXPECT_NE(attach.Ask("send JointMover.Mov\tfr\tRCServer.M\t1\r",
                       ": send JointMover.Mover.MoverCommand.O from RCServer.Mover.MoverCommand.S "
                       "1\r\n"),
            "")
      << attach.shown();
  EXPECT_NE(attach.Ask("nonsense" + std::string(kCtrlC), "^C\r\n"), "") << attach.shown();
  attach.Type("qui\t\r");
  EXPECT_EQ(attach.Finish(), 0) << attach.shown();
}

TEST_F(PromptAtTerminalTest, TabCompletesNothingWhenTheRunHasEnded) {
  ProgramRun run({"run", "--rc-port", "0", "--body", "ideal", "--no-panel", "--run-name", "alive"});
  ASSERT_TRUE(run.WaitFor("remote control: "));
  TerminalRun attach({"attach", "alive"}, "alive> ");
  ASSERT_TRUE(attach.WaitFor("alive> ")) << attach.shown();
  run.Signal(SIGKILL);
  run.Finish();
  attach.Type("stat\tus\r");
  EXPECT_EQ(attach.Finish(), 1) << attach.shown();
  EXPECT_THAT(attach.shown(), HasSubstr("has ended\r\n"));
  EXPECT_TRUE(attach.IsAsBefore());
}

TEST_F(PromptAtTerminalTest, WithoutLibeditLinesAreReadAsTheTerminalGivesThem) {
  // The loader meets this file first, and it is no library.
  const ScratchFolder libraries;
  libraries.Write("libedit.so.2", "");
  const std::string file = Record();
  setenv("LD_LIBRARY_PATH", libraries.path().c_str(), 1);
  TerminalRun step({"replay", file, "--step"}, "(");
  unsetenv("LD_LIBRARY_PATH");
  ASSERT_TRUE(step.WaitFor("(start) ")) << step.shown();
  EXPECT_NE(step.Ask("step\r", "t="), "") << step.shown();
  step.Type(kCtrlD);
  EXPECT_EQ(step.Finish(), 0) << step.shown();
}

}  // namespace
}  // namespace openr_host
