// A recording, or a failing run of an exploration, that is watched on the panel.
#include <gmock/gmock.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "openr/live/live_folder.h"
#include "tests/openr/panel_server.h"
#include "tests/openr/watcher.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

class KnownRunTest : public PanelTest {
 protected:
  // Starts a program that shows a known run, and watches it.
  void Show(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--panel", "--panel-port", "0"});
    program_ = std::make_unique<ProgramRun>(arguments);
    ASSERT_TRUE(program_->WaitFor("can be watched")) << program_->Finish().err;
    ASSERT_EQ(LiveRuns().size(), 1u);
    Watch(LiveRuns().at(0).socket);
  }

  void Watch(const std::string& socket) {
    watcher_ = std::make_unique<Watcher>(socket);
    Ask(R"({"do":"watch","period_ms":50,"events":["clock"]})");
  }

  // Records a run of `length_s` on the ideal body in which the chin is pressed at 1 s.
  std::string Record(int length_s) {
    const std::string file = files_.File("walk.rec"), events = files_.File("hands.txt");
    files_.Write("hands.txt", "1s press chin\n");
    const ProgramResult result =
        RunProgram({"run", "--body", "ideal", "--rate", "max", "--no-panel", "--rc-port", "0",
                    "--for", std::to_string(length_s) + "s", "--events", events, "--record", file});
    EXPECT_EQ(result.status, 0) << result.err;
    return file;
  }

  Json Ask(const std::string& request) { return watcher_->Ask(request); }
  Json Hashes() { return Ask(R"({"do":"hashes"})"); }
  std::string Error(const std::string& request) { return Ask(request).value("error", "none"); }

  // Lets the run go to a later moment, and waits until it is there.
  Json GoTo(double time_s) {
    EXPECT_EQ(Error(R"({"do":"clock","to_s":)" + std::to_string(time_s) + "}"), "none");
    return watcher_->WaitFor("clock", [&](const Json& clock) {
      return clock.at("time_s") == time_s && clock.at("paused") == true;
    });
  }
  Json Rewind(double time_s) {
    return Ask(R"({"do":"rewind","to_s":)" + std::to_string(time_s) + "}");
  }
  int Chin() {
    const Json answer = Ask(R"({"do":"sensors","robot":0})");
    for (const Json& sensor : answer.at("sensors")) {
      if (sensor.at("name") == "chin") return sensor.at("value").get<int>();
    }
    return -1;
  }

  const ScratchFolder files_;
  std::unique_ptr<ProgramRun> program_;
  std::unique_ptr<Watcher> watcher_;
};

TEST_F(KnownRunTest, ARecordingGoesToAnyMomentAndBack) {
  Show({"replay", Record(6)});
  EXPECT_FALSE(GoTo(0.8).is_null());
  EXPECT_EQ(Chin(), 0);
  EXPECT_FALSE(GoTo(4).is_null());
  EXPECT_EQ(Chin(), 1);
  const Json at_4s = Hashes();
  EXPECT_EQ(Rewind(0.8).at("rewind").at("shows_s"), 0.8);
  EXPECT_EQ(Chin(), 0);
  EXPECT_EQ(Rewind(4).at("time_s"), 4);
  EXPECT_EQ(Hashes(), at_4s);
  const Json end = GoTo(6);  // out of the past
  EXPECT_EQ(end.at("over"), "the recording is over");
  EXPECT_EQ(end.at("length_s"), 6);
}

TEST_F(KnownRunTest, ARecordingIsPlayedAgainFromTheMomentShown) {
  Show({"replay", Record(6)});
  GoTo(3);
  const Json at_3s = Hashes();
  GoTo(6);
  Rewind(2);
  const Json answer = Ask(R"({"do":"branch"})");
  ASSERT_TRUE(answer.contains("run")) << answer;
  Watch(LiveFolder() + "/" + answer.value("run", "none"));
  EXPECT_FALSE(GoTo(3).is_null());
  EXPECT_EQ(Hashes(), at_3s);
  EXPECT_EQ(GoTo(6).at("over"), "the recording is over");
  program_->Signal(SIGTERM);
  EXPECT_EQ(program_->Finish().status, 0) << program_->Finish().err;
}

TEST_F(KnownRunTest, NobodyChangesARecording) {
  Show({"replay", Record(2)});
  EXPECT_EQ(Error(R"({"do":"input","robot":0,"line":"press chin"})"),
            "this is a recording; nothing can be changed");
  EXPECT_EQ(Error(R"({"do":"clock","to_s":3})"), "the recording is over at t=2.000 s");
  EXPECT_EQ(Ask(R"({"do":"clock","step":"message"})").value("error", "none"), "none");
  program_->Signal(SIGINT);
  EXPECT_EQ(program_->Finish().status, 0);
}

TEST_F(KnownRunTest, AFailingRunOfAnExplorationEndsWhereThePropertyIsBroken) {
  const std::string failure = files_.File("failure.json");
  EXPECT_EQ(RunProgram({"explore", "--body", "ideal", "--seed", "2", "--property",
                        "eventually objects.JointMover.state == dancing", "--for", "200ms",
                        "--runs", "1", "--jobs", "1", "-o", failure})
                .status,
            1);
  Show({"explore", "--replay", failure});
  EXPECT_EQ(Ask(R"({"do":"clock"})").at("length_s"), 0.2);
  EXPECT_THAT(GoTo(0.2).at("over").get<std::string>(), HasSubstr("objects.JointMover.state"));
  const Json end = Hashes();
  EXPECT_EQ(Rewind(0.024).at("time_s"), 0.024);
  Rewind(0.2);
  EXPECT_EQ(Hashes(), end);
}

TEST_F(KnownRunTest, TheFlagsOfThePanelNeedIt) {
  const ProgramResult result = RunProgram({"replay", "none.rec", "--rate", "2"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("--panel"));
}

}  // namespace
}  // namespace openr_host
