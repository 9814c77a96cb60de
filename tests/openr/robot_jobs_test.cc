// openr run --robots N --jobs K: each robot in a process of its own.
#include <gmock/gmock.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/openr/program_run.h"
#include "tests/openr/terminal_run.h"

namespace openr_host {
namespace {

using nlohmann::json;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

using Words = std::vector<std::string>;

Words JobWords(const std::string& robots, const std::string& jobs, const Words& more) {
  Words words{"run", "--rate", "max",      "--body", "ideal",  "--for",
              "1s",  "--json", "--robots", robots,   "--jobs", jobs};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

json ReportOf(const std::string& robots, const std::string& jobs, int status = 0,
              const Words& more = {}) {
  const ProgramResult result = RunProgram(JobWords(robots, jobs, more));
  EXPECT_EQ(result.status, status) << result.err;
  return json::parse(result.out, nullptr, false);
}

TEST(RobotJobsTest, TheHashesOfARobotDependNeitherOnTheNumberOfRobotsNorOfJobs) {
  const json many = ReportOf("5", "2"), few = ReportOf("3", "1");
  ASSERT_EQ(many["robots"].size(), 5u);
  ASSERT_EQ(few["robots"].size(), 3u);
  std::set<std::string> states;
  for (size_t i = 0; i < 5; ++i) {
    const json& robot = many["robots"][i];
    EXPECT_EQ(robot["number"], i);
    states.insert(robot["state_hash"].get<std::string>());
    if (i >= 3) continue;
    EXPECT_EQ(robot["state_hash"], few["robots"][i]["state_hash"]);
    EXPECT_EQ(robot["trace_hash"], few["robots"][i]["trace_hash"]);
  }
  EXPECT_EQ(states.size(), 5u) << "the noise of the sensors differs from robot to robot";
  EXPECT_EQ(many["state_hash"], ReportOf("5", "5")["state_hash"]);
  EXPECT_EQ(many["messages"].get<uint64_t>(), 5 * many["robots"][0]["messages"].get<uint64_t>());
}

TEST(RobotJobsTest, TheFirstRobotEndsInTheStateOfARunOfOne) {
  const json one = json::parse(RunProgram({"run", "--rate", "max", "--body", "ideal", "--for", "1s",
                                           "--json", "--rc-port", "0"})
                                   .out);
  const json first = ReportOf("2", "2")["robots"][0];
  EXPECT_EQ(first["state_hash"], one["state_hash"]);
}

TEST(RobotJobsTest, ObjectsAndFindingsSayTheirRobot) {
  const json report = ReportOf("3", "2", 0, {"--battery", "9%"});
  ASSERT_EQ(report["findings"].size(), 3u);
  std::set<int> robots;
  for (const json& object : report["objects"]) robots.insert(object["robot"].get<int>());
  EXPECT_EQ(robots, (std::set<int>{0, 1, 2}));
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(report["findings"][i]["robot"], i);
}

TEST(RobotJobsTest, ACrashEndsItsRobotOnly) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  const json report = ReportOf("3", "2", 1, {"--stick", stick.path()});
  ASSERT_EQ(report["robots"].size(), 3u);
  ASSERT_EQ(report["findings"].size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(report["robots"][i]["ended_by"], "crash");
    EXPECT_EQ(report["findings"][i]["robot"], i);
    EXPECT_EQ(report["findings"][i]["severity"], "error");
  }
}

TEST(RobotJobsTest, CtrlCPausesTheRobotsThatRunAndStartsNoOthers) {
  ProgramRun run({"run", "--rate", "max", "--body", "ideal", "--battery", "100%", "--json",
                  "--robots", "3", "--jobs", "2"});
  ASSERT_TRUE(run.WaitFor("robot 1: "));
  run.Signal(SIGINT);
  const ProgramResult& result = run.Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  const json report = json::parse(result.out, nullptr, false);
  EXPECT_EQ(report["ended_by"], "pause");
  ASSERT_EQ(report["robots"].size(), 2u);
  for (const json& robot : report["robots"]) EXPECT_EQ(robot["ended_by"], "pause");
  EXPECT_THAT(result.err, HasSubstr("openr: 1 robot not started, because Ctrl-C or SIGTERM came"));
}

TEST(RobotJobsTest, AKeyAtTheTerminalDoesNotStopTheRobots) {
  TerminalRun run({"run", "--rate", "max", "--body", "ideal", "--battery", "100%", "--for", "200s",
                   "--robots", "2", "--jobs", "2"},
                  "(");
  ASSERT_TRUE(run.WaitFor("robot 1: "));
  run.Type("\n");
  EXPECT_TRUE(run.WaitFor("200.000 s of virtual time each")) << run.shown();
  EXPECT_EQ(run.Finish(), 0);
}

TEST(RobotJobsTest, RobotsThatDoNotBootAreReported) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  stick.Write("OPEN-R/MW/CONF/OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/NOBODY.BIN\n");
  const json report = ReportOf("3", "2", 1, {"--stick", stick.path()});
  EXPECT_EQ(report["ended_by"], "no-boot");
}

TEST(RobotJobsTest, TheLastLineSaysWhatEndedTheRun) {
  const ProgramResult result = RunProgram(JobWords("2", "2", {}));
  EXPECT_THAT(result.err, HasSubstr("\n2 robots, "));
  EXPECT_THAT(result.err, EndsWith("\nended by time: --for 1s is over\n"));
  EXPECT_THAT(result.err, Not(HasSubstr("remote control: "))) << "nobody can reach the robots";
  EXPECT_EQ(json::parse(result.out)["robots"][1]["rc_port"], 0);
}

TEST(RobotJobsTest, FlagsThatMakeNoSenseBesideItAreRefusedWithTheReason) {
  const ScratchFolder folder;
  for (const Words& wrong : std::vector<Words>{{"--rate", "1"},
                                               {"--place", "JointMover=legs"},
                                               {"--isolate", "JointMover"},
                                               {"--ros2"},
                                               {"--monitor"},
                                               {"--panel"},
                                               {"--rc-port", "0"},
                                               {"--ip", "10.0.1.2=127.0.0.1"},
                                               {"--stdin", "-"},
                                               {"--speaker", folder.File("a.wav")},
                                               {"--snapshot", "t=end", "-o", folder.File("a.png")},
                                               {"--record", folder.File("a.trace")}}) {
    Words words{"run", "--for", "1s", "--robots", "2", "--jobs", "2"};
    if (wrong[0] != "--rate") words.insert(words.end(), {"--rate", "max"});
    words.insert(words.end(), wrong.begin(), wrong.end());
    const ProgramResult result = RunProgram(words);
    EXPECT_EQ(result.status, 2) << wrong[0];
    EXPECT_THAT(result.err, HasSubstr(wrong[0] + ": does not go with --jobs: ")) << wrong[0];
  }
}

}  // namespace
}  // namespace openr_host
