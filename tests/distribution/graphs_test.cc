// The default stick in one process, in two processes, and with a worker for each object gives the
// same bytes.  tests/examples compares the examples, apart_test.cc other objects.
#include <gmock/gmock.h>
#include <signal.h>

#include "tests/distribution/sticks.h"

namespace openr_host {
namespace {

const Words kTwo = {"--place", "Controller=brain", "--place", "RCServer=brain"};
const Words kFive = Isolated({"PowerMonitor", "JointMover", "RCServer", "Controller"});

class GraphsTest : public testing::Test {
 protected:
  // Compares the run in one process with each placement.
  static void Compare(const Words& flags) {
    const RecordedRun one = Record(flags);
    EXPECT_EQ(one.status, 0) << one.err;
    for (const Words& places : {kTwo, kFive}) ExpectSame(one, Record(flags + places));
  }
};

TEST_F(GraphsTest, WithPhysics) { Compare({"--for", "5s"}); }

TEST_F(GraphsTest, OnItsFeet) { Compare({"--for", "20s", "--body", "ideal"}); }

TEST_F(GraphsTest, WithAnotherSeed) { Compare({"--for", "10s", "--body", "ideal", "--seed", "7"}); }

TEST_F(GraphsTest, WithTheLimitsOfTheRobot) {
  Compare({"--for", "10s", "--body", "ideal", "--strict"});
}

TEST_F(GraphsTest, WhenHandlersTakeTime) {
  Compare({"--for", "10s", "--body", "ideal", "--cost", OPENR_COST});
}

TEST_F(GraphsTest, OfAnotherModel) {
  Compare({"--for", "5s", "--body", "ideal", "--robot", "ers7"});
}

TEST_F(GraphsTest, WithEachObjectAlone) {
  const Words flags = {"--for", "3s", "--body", "ideal"};
  const RecordedRun one = Record(flags);
  for (const char* object : {"PowerMonitor", "JointMover", "RCServer", "Controller"}) {
    SCOPED_TRACE(object);
    ExpectSame(one, Record(flags + Isolated({object})));
  }
}

TEST_F(GraphsTest, TwoDogsHaveTheSameHashes) {
  const Words flags = kQuickly + Words{"--for", "5s", "--body", "ideal", "--robots", "2"};
  const json one = json::parse(RunProgram(flags).out);
  for (const Words& places : {kTwo, kFive}) {
    const ProgramResult result = RunProgram(flags + places);
    EXPECT_EQ(result.status, 0) << result.err;
    const json other = json::parse(result.out, nullptr, false);
    ASSERT_TRUE(other.is_object()) << result.err;
    EXPECT_EQ(one["state_hash"], other["state_hash"]);
    EXPECT_EQ(one["trace_hash"], other["trace_hash"]);
  }
}

TEST_F(GraphsTest, TheReportNamesProcessesThatAreProcesses) {
  ProgramRun run(Words{"run", "--no-panel", "--rc-port", "0", "--json", "--body", "ideal"} + kTwo +
                 Isolated({"JointMover"}));
  ASSERT_TRUE(run.WaitFor("state: listening")) << run.heard();
  const std::vector<pid_t> children = ChildrenOf(run.pid());
  run.Signal(SIGINT);
  const ProgramResult& result = run.Finish();
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  const json& processes = report["processes"];
  ASSERT_EQ(processes.size(), 2u);
  EXPECT_EQ(processes[0]["name"], "JointMover");
  EXPECT_EQ(processes[1]["name"], "brain");
  EXPECT_EQ(processes[1]["objects"], json({"RCServer", "Controller"}));
  EXPECT_EQ(processes[0]["lost"], "");
  const std::vector<pid_t> named = {processes[0]["pid"], processes[1]["pid"]};
  EXPECT_THAT(named, testing::UnorderedElementsAreArray(children));
}

TEST_F(GraphsTest, TheReportKnowsTheHeapOfObjectsElsewhere) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "AddressSanitizer has the heap";
#endif
  const auto heap = [](const Words& places) {
    const RecordedRun run = Record(Words{"--for", "2s", "--body", "ideal"} + places);
    std::map<std::string, double> bytes;
    for (const json& object : run.report["objects"])
      bytes[object["name"]] = object["heap_bytes_max"];
    return bytes;
  };
  auto here = heap({}), there = heap(kFive);
  for (const char* name : {"JointMover", "RCServer", "Controller"}) {
    EXPECT_GT(here[name], 0) << name;
    EXPECT_NEAR(there[name], here[name], here[name] / 2) << name;
  }
}

TEST_F(GraphsTest, ARecordingOfManyProcessesIsReplayedInOne) {
  const ScratchFolder folder;
  const ProgramResult run =
      RunProgram(kQuickly + Words{"--for", "5s", "--record", folder.File("r")} + kFive);
  ASSERT_EQ(run.status, 0) << run.err;
  const ProgramResult replay = RunProgram({"replay", folder.File("r")});
  EXPECT_EQ(replay.status, 0) << replay.out << replay.err;
}

// Keeper has a map on its heap, a static variable, a connection to itself, and a file.
TEST_F(GraphsTest, AnObjectKeepsItsMemoryAndItsFile) {
  const auto run = [](const Words& places) {
    const ScratchFolder stick;
    MakeStick(stick, {"KEEPER.BIN"},
              "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S "
              "Keeper.Sensor.OSensorFrameVectorData.O\n"
              "Keeper.Out.Number.S Keeper.In.Number.O\n");
    stick.Write("OPEN-R/MW/DATA/P/KEPT.TXT", "before\n");
    const ProgramResult result =
        RunProgram(kQuickly + Words{"--for", "10s", "--stick", stick.path()} + places);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(stick.Read("OPEN-R/MW/DATA/P/KEPT.TXT"), "1\n");
    const json report = json::parse(result.out, nullptr, false);
    EXPECT_GT(report.value("messages", 0), 2500);
    return report.value("trace_hash", "none");
  };
  EXPECT_EQ(run({}), run(Isolated({"Keeper"})));
}

// A megabyte goes to two other objects and to the sender itself, so buffers and counts are in three
// processes.
TEST_F(GraphsTest, AMegabyteForSeveralObservers) {
  const ScratchFolder stick;
  MakeBulkStick(stick);
  const Words flags = {"--for", "2s", "--stick", stick.path()};
  const RecordedRun one = Record(flags);
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_GT(one.recording.size(), 12'000'000u) << "the bytes are in the recording";
  EXPECT_NE(one.err.find("Bulk heard itself: 2 data"), std::string::npos) << one.err;
  EXPECT_NE(one.err.find("in round 12"), std::string::npos) << one.err;
  for (const Words& objects : {Words{"Bulk"}, Words{"Taker2"}, Words{"Bulk", "Taker1", "Taker2"}}) {
    SCOPED_TRACE(testing::PrintToString(objects));
    ExpectSame(one, Record(flags + Isolated(objects)));
  }
  ExpectSame(one, Record(flags + Words{"--place", "Bulk=a", "--place", "Taker1=a"}));
}

}  // namespace
}  // namespace openr_host
