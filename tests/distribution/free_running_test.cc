// Free-running: openr run --free-running.
#include <gmock/gmock.h>

#include <chrono>

#include "tests/distribution/same_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

TEST(FreeRunningTest, ObjectsElsewhereDoTheirWork) {
  const auto begin = std::chrono::steady_clock::now();
  const ProgramResult result =
      RunProgram(Words{"run", "--for", "5s", "--body", "ideal", "--no-panel", "--rc-port", "0",
                       "--json", "--free-running", "--rate", "5"} +
                 Isolated({"JointMover", "RCServer"}));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1)) << "5 s at 5";
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_EQ(report["processes"].size(), 2u) << result.out;
  EXPECT_FALSE(report.contains("trace_hash"));
  for (const json& process : report["processes"]) {
    EXPECT_EQ(process["lost"], "");
    EXPECT_GT(process["handlers"], 5);
    const json& times = process["handler_us"];
    EXPECT_GT(times["median"], 0);
    EXPECT_LE(times["median"], times["p99"]);
    EXPECT_LE(times["p99"], times["max"]);
  }
  // JointMover has printed this, so its handlers have run.
  EXPECT_THAT(result.err, HasSubstr("state: gains"));
}

TEST(FreeRunningTest, FreeRunningNeedsARateAndAPlacement) {
  EXPECT_THAT(
      RunProgram(kQuickly + Words{"--for", "1s", "--free-running", "--isolate", "RCServer"}).err,
      HasSubstr("--rate max has none"));
  EXPECT_THAT(RunProgram({"run", "--for", "1s", "--free-running"}).err,
              HasSubstr("no object is placed in another process"));
}

TEST(FreeRunningTest, ARecordingOfItIsShownButNotReplayed) {
  const ScratchFolder folder;
  const std::string file = folder.File("r");
  const ProgramResult run =
      RunProgram({"run", "--for", "1s", "--body", "ideal", "--no-panel", "--rc-port", "0",
                  "--record", file, "--free-running", "--isolate", "JointMover"});
  EXPECT_EQ(run.status, 0) << run.err;
  const ProgramResult replay = RunProgram({"replay", file});
  EXPECT_EQ(replay.status, 1);
  EXPECT_THAT(replay.err, HasSubstr(file + ": a free run (--free-running) cannot be replayed"));
  EXPECT_EQ(RunProgram({"trace", file}).status, 0);
}

}  // namespace
}  // namespace openr_host
