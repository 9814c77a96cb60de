// The progress line of commands at a terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "runtime/base/temp_folder.h"
#include "tests/openr/program_run.h"
#include "tests/openr/terminal_run.h"

namespace openr_host {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr char kTime[] = "s of virtual time", kBytes[] = "MB read", kTimeLeft[] = " left";

class ProgressTest : public testing::Test {
 protected:
  ProgressTest() {
    setenv("TERM", "xterm", 1);
    setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1);
    setenv("OPENR_HOST_PROGRESS_MS", "0", 1);  // so that the short runs of the test show a line
  }
  ~ProgressTest() override {
    unsetenv("XDG_RUNTIME_DIR");
    unsetenv("OPENR_HOST_PROGRESS_MS");
  }

  std::string At(const std::string& name) const { return folder_.path() + "/" + name; }

  // Records a run of two seconds, and writes its data to a file named `log`.  Returns the
  // recording.
  std::string Record(const std::string& log = "run.csv") const {
    const ProgramResult run = RunProgram({"run", "--body", "ideal", "--for", "2s", "--rate", "max",
                                          "--no-panel", "--rc-port", "0", "--stick", OPENR_STICK,
                                          "--record", At("run.rec"), "--log-data", At(log)});
    EXPECT_EQ(run.status, 0) << run.err;
    return At("run.rec");
  }

  // Returns what the command shows on a terminal.
  static std::string Shown(const std::vector<std::string>& arguments) {
    TerminalRun run(arguments, "(");
    EXPECT_EQ(run.Finish(), 0) << run.shown();
    return run.shown();
  }

  const TempFolder folder_;
};

TEST_F(ProgressTest, GraphShowsTheTimeOfItsRun) {
  EXPECT_THAT(Shown({"graph", "--stick", OPENR_STICK, "--for", "20s"}), HasSubstr(kTime));
}

TEST_F(ProgressTest, ReplayShowsItsTimeButNotBesideJson) {
  const std::string file = Record();
  EXPECT_THAT(Shown({"replay", file}), HasSubstr(kTime));
  EXPECT_THAT(Shown({"replay", file, "--log-data", At("again.csv")}), HasSubstr(kTime));
  EXPECT_THAT(Shown({"replay", file, "--json", "--log-data", At("again.csv")}),
              Not(HasSubstr(kTimeLeft)));
}

TEST_F(ProgressTest, ReplayThatGoesOnShowsTheTimeUpToThereAndOfTheRest) {
  const std::string shown =
      Shown({"replay", Record(), "--continue-at", "1s", "--for", "3s", "--rate", "max"});
  EXPECT_THAT(shown, HasSubstr("of 1 s of virtual time"));
  EXPECT_THAT(shown, HasSubstr("of 3 s of virtual time"));
}

TEST_F(ProgressTest, PlotShowsTheTimeOfARecordingAndTheBytesOfALog) {
  const std::string chart = At("chart.svg");
  const std::string of_recording = Shown({"plot", Record(), "-o", chart});
  EXPECT_THAT(of_recording, HasSubstr(kTime));
  EXPECT_THAT(of_recording, HasSubstr(kBytes));
  EXPECT_THAT(Shown({"plot", At("run.csv"), "-o", chart}), HasSubstr(kBytes));
  Record("run.mcap");
  EXPECT_THAT(Shown({"plot", At("run.mcap"), "-o", chart}), HasSubstr(kBytes));
}

TEST_F(ProgressTest, StepPromptShowsTheTimeOrTheMessagesToWhereItGoes) {
  TerminalRun step({"replay", Record(), "--step"}, "(");
  ASSERT_TRUE(step.WaitFor("(start) ")) << step.shown();
  EXPECT_THAT(step.Ask("goto 1s\r", "t=1.0"), HasSubstr("of 1 s of virtual time"));
  EXPECT_THAT(step.Ask("goto 0\r", "at the start"), Not(HasSubstr("openr: ")));
  EXPECT_THAT(step.Ask("step 7\r", "t=0"), HasSubstr("of 7 messages"));
  EXPECT_THAT(step.Ask("goto 1.6s\r", "t=1.6"), HasSubstr("of 1 s of virtual time"));
  EXPECT_THAT(step.Ask("goto 480ms\r", "t=0.48"), HasSubstr("of 0 s of virtual time"));
  EXPECT_THAT(step.Ask("run\r", "at the end of the recording"),
              HasSubstr("of 1 s of virtual time"));
  step.Type("quit\r");
  EXPECT_EQ(step.Finish(), 0) << step.shown();
}

}  // namespace
}  // namespace openr_host
