// Going back in a run that goes on, and going on from there.
#include <gmock/gmock.h>
#include <signal.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "openr/live/live_folder.h"
#include "openr/remote/connection.h"
#include "runtime/base/read_file.h"
#include "runtime/base/temp_folder.h"
#include "tests/openr/program_run.h"
#include "tests/openr/watcher.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using OrderedJson = nlohmann::ordered_json;

// Returns the names of what is in a folder.
std::set<std::string> NamesIn(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename());
  return names;
}

class RewindTest : public ::testing::Test {
 protected:
  RewindTest() { setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1); }
  ~RewindTest() override { unsetenv("XDG_RUNTIME_DIR"); }

  // Starts a run that is watched, so that it takes checkpoints.
  void Start(std::vector<std::string> flags = {}) {
    std::vector<std::string> arguments = {"run",        "--rc-port",  "0",
                                          "--no-panel", "--run-name", "back"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    run_ = std::make_unique<ProgramRun>(arguments);
    ASSERT_TRUE(run_->WaitFor("remote control"));
    Watch();
  }

  void Watch() { Watch(LiveRuns().at(0).socket); }
  void Watch(const std::string& socket) {
    watcher_ = std::make_unique<Watcher>(socket);
    watcher_->Ask(R"({"do":"watch","period_ms":16,"events":["clock","pose","values","graph"]})");
  }

  OrderedJson Ask(const std::string& request) { return watcher_->Ask(request); }
  // Goes on from the moment shown, and watches the new run.  Returns the answer.
  OrderedJson Branch() {
    const OrderedJson answer = Ask(R"({"do":"branch"})");
    EXPECT_TRUE(answer.contains("run")) << answer;
    Watch(LiveFolder() + "/" + answer.value("run", "none"));
    return answer;
  }

  OrderedJson Hashes() { return Ask(R"({"do":"hashes"})"); }
  std::string Error(const std::string& request) { return Ask(request).value("error", "none"); }
  void Input(const std::string& line) {
    EXPECT_EQ(Error(R"({"do":"input","robot":0,"line":")" + line + "\"}"), "none");
  }

  // Lets the run go on to a virtual time, and pauses it a little later.  At full speed it could go
  // on for minutes of virtual time until the pause comes.
  void RunTo(double time_s, const std::string& rate = "20") {
    Ask(R"({"do":"clock","pause":false,"rate":)" + rate + "}");
    const OrderedJson clock = watcher_->WaitFor(
        "clock", [&](const OrderedJson& event) { return event.at("time_s") >= time_s; });
    ASSERT_FALSE(clock.is_null());
    Ask(R"({"do":"clock","pause":true})");
  }

  OrderedJson GoTo(double time_s) {
    return Ask(R"({"do":"rewind","to_s":)" + std::to_string(time_s) + "}");
  }

  int Replay(const std::string& file) {
    ProgramRun replay({"replay", file});
    return replay.Finish().status;
  }

  const TempFolder folder_;
  std::unique_ptr<ProgramRun> run_;
  std::unique_ptr<Watcher> watcher_;
};

TEST_F(RewindTest, ARunWithASecondRobotGoesInRealTimeAndNotBack) {
  Start({"--rate", "4"});
  RunTo(1, "4");
  Watcher second(LiveRuns().at(0).socket);
  EXPECT_EQ(second.Ask(R"({"do":"couple","robot":0,"with":"dog:54000"})").at("rate"), 1);
  EXPECT_THAT(Error(R"({"do":"rewind","back_s":0.5})"),
              HasSubstr("the robot at dog:54000 is connected, and cannot go back with it"));
  EXPECT_THAT(Error(R"({"do":"couple","robot":0,"with":"cat:54000"})"),
              HasSubstr("robot 0 is connected to dog:54000 by another"));
  EXPECT_EQ(second.Ask(R"({"do":"couple","robot":0})").at("rate"), 4);
  EXPECT_EQ(GoTo(0.5).value("error", "none"), "none");
  EXPECT_THAT(Error(R"({"do":"couple","robot":0,"with":"dog:54000"})"),
              HasSubstr("a moment of the past is shown"));
}

TEST_F(RewindTest, WhatASecondRobotHasChangedEndsWithTheConnectionOfItsClient) {
  Start({"--rate", "4"});
  {
    Watcher second(LiveRuns().at(0).socket);
    EXPECT_EQ(second.Ask(R"({"do":"couple","robot":0,"with":"dog:54000"})").at("rate"), 1);
  }
  EXPECT_FALSE(
      watcher_->WaitFor("clock", [](const OrderedJson& event) { return event.at("rate") == 4; })
          .is_null());
}

TEST_F(RewindTest, TheMomentShownIsTheOneThatWas) {
  Start({"--body", "ode"});
  RunTo(6, "8");
  const OrderedJson then = Hashes();
  Input("press chin for 300ms");
  Input("push 0 4 0");
  RunTo(9, "8");
  const OrderedJson now = Hashes();
  const OrderedJson clock = GoTo(then.at("time_s"));
  EXPECT_EQ(clock.at("rewind").at("shows_s"), then.at("time_s"));
  EXPECT_EQ(clock.at("paused"), true);
  // The inputs were added at this very instant, so they are in the queue of inputs.
  const OrderedJson shown = Hashes();
  EXPECT_EQ(shown.at("trace_hash"), then.at("trace_hash"));
  GoTo(now.at("time_s"));
  EXPECT_EQ(Hashes(), now);
  GoTo(then.at("time_s"));
  EXPECT_EQ(Hashes(), shown);
  Ask(R"({"do":"rewind","present":true})");
  EXPECT_EQ(Hashes(), now);
}

TEST_F(RewindTest, EveryMessageCanBeShown) {
  Start({"--body", "ideal"});
  RunTo(5);
  const uint64_t last = Hashes().at("messages");
  for (uint64_t count = last - 20; count <= last; count += 5) {
    const std::string to = std::to_string(count);
    EXPECT_EQ(Ask(R"({"do":"rewind","to_message":)" + to + "}").value("messages", uint64_t{0}),
              count);
    EXPECT_EQ(Hashes().at("messages"), count);
  }
  Ask(R"({"do":"rewind","to_message":)" + std::to_string(last - 20) + "}");
  EXPECT_EQ(Ask(R"({"do":"clock","step":"message"})").at("messages"), last - 19);
  const double time_s = Ask(R"({"do":"clock","step":"frame"})").at("time_s");
  EXPECT_NEAR(Ask(R"({"do":"clock","step":"frame"})").at("time_s"), time_s + 0.008, 1e-9);
  EXPECT_NEAR(Ask(R"({"do":"rewind","back_s":1})").at("time_s"), time_s - 0.992, 1e-9);
}

TEST_F(RewindTest, TheEventsAreThoseOfTheMoment) {
  Start({"--body", "ideal"});
  RunTo(2);
  Input("press chin");
  RunTo(8);
  const auto chin = [&] {
    const OrderedJson answer = Ask(R"({"do":"sensors","robot":0})");
    for (const OrderedJson& sensor : answer.at("sensors")) {
      if (sensor.at("name") == "chin") return sensor.at("value").get<int>();
    }
    return -1;
  };
  EXPECT_EQ(chin(), 1);
  watcher_->DropEvents();
  const double first_s = Ask(R"({"do":"clock"})").at("rewind").at("from_s");
  GoTo(first_s);
  EXPECT_EQ(chin(), 0);
  const OrderedJson pose =
      watcher_->WaitFor("pose", [](const OrderedJson& event) { return event.at("time_s") < 2; });
  EXPECT_EQ(pose.at("time_s"), first_s);
  Ask(R"({"do":"rewind","present":true})");
  EXPECT_FALSE(
      watcher_->WaitFor("pose", [](const OrderedJson& event) { return event.at("time_s") > 7; })
          .is_null());
}

TEST_F(RewindTest, TheFindingsOfAMomentAreSentEachTimeThatItIsShown) {
  Start({"--body", "ideal"});
  RunTo(5);
  Ask(R"({"do":"watch","events":["clock","findings"]})");
  const double first_s = Ask(R"({"do":"clock"})").at("rewind").at("from_s");
  for (int i = 0; i < 2; ++i) {
    GoTo(first_s);
    EXPECT_FALSE(
        watcher_
            ->WaitFor("findings",
                      [&](const OrderedJson& event) { return event.at("time_s") == first_s; })
            .is_null());
    Ask(R"({"do":"rewind","present":true})");
    EXPECT_FALSE(
        watcher_
            ->WaitFor("findings", [](const OrderedJson& event) { return event.at("time_s") > 4; })
            .is_null());
  }
}

TEST_F(RewindTest, ABranchIsARunOfItsOwnWithItsOwnRecording) {
  const std::string file = folder_.path() + "/run.rec";
  Start({"--body", "ode", "--record", file, "--for", "30s"});
  RunTo(4);
  const OrderedJson then = Hashes();
  RunTo(12);
  GoTo(then.at("time_s"));
  EXPECT_EQ(Branch().at("files"), OrderedJson::array({folder_.path() + "/run-2.rec"}));
  EXPECT_LT(Ask(R"({"do":"clock"})").at("time_s"), 12);
  Input("press back for 100ms");
  Ask(R"({"do":"clock","rate":0})");
  const ProgramResult& result = run_->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("ended by branch: "));
  EXPECT_THAT(result.err, HasSubstr("ended by time: --for 30s is over"));
  EXPECT_EQ(Replay(file), 0);
  EXPECT_EQ(Replay(folder_.path() + "/run-2.rec"), 0);
}

TEST_F(RewindTest, ABranchHasATimelineOfItsOwn) {
  const std::string trace = folder_.path() + "/run.ctf", branch = folder_.path() + "/run-2.ctf";
  Start({"--body", "ideal", "--timeline", trace, "--for", "10s"});
  RunTo(4);
  EXPECT_EQ(Error(R"({"do":"rewind","back_s":1})"), "none");
  EXPECT_EQ(Branch().at("files"), OrderedJson::array({branch}));
  Ask(R"({"do":"clock","rate":0})");
  EXPECT_EQ(run_->Finish().status, 0);
  // Readers take all files of a folder together, so the branch must not add any to the first one.
  const std::set<std::string> files = {"handlers", "metadata"};
  EXPECT_EQ(NamesIn(trace), files);
  EXPECT_EQ(NamesIn(branch), files);
  EXPECT_GT(std::filesystem::file_size(branch + "/handlers"), 1000u);
}

TEST_F(RewindTest, ABranchOfABranchGoesOn) {
  Start({"--body", "ideal"});
  for (int i = 0; i < 3; ++i) {
    RunTo(3);
    EXPECT_EQ(Error(R"({"do":"rewind","back_s":0})"), "none");
    Ask(R"({"do":"clock","rate":1})");
    Branch();
    watcher_->WaitFor(
        "clock", [](const OrderedJson& clock) { return clock.at("rewind").at("checkpoints") > 0; });
  }
  Input("press pause");
  EXPECT_EQ(run_->Finish().status, 0);
}

TEST_F(RewindTest, ClientsOfTheFirstRunAreClosedAndTheBranchServesNewOnes) {
  Start({"--body", "ideal"});
  RunTo(20);
  Ask(R"({"do":"clock","pause":false,"rate":1})");
  const uint16_t port = Ask(R"({"do":"status"})").at("rc_ports").at(0);
  openr::remote::Connection client({"127.0.0.1", port}, {.timeout = std::chrono::seconds(10)});
  client.Request(rcINFO);
  const double time_s = Hashes().at("time_s");
  EXPECT_EQ(Error(R"({"do":"rewind","back_s":0})"), "none");
  Branch();
  EXPECT_THROW(client.Request(rcINFO), std::runtime_error);
  EXPECT_EQ(Ask(R"({"do":"status"})").at("rc_ports").at(0), port);
  openr::remote::Connection second({"127.0.0.1", port}, {.timeout = std::chrono::seconds(10)});
  EXPECT_GE(second.Request(rcINFO).frame, static_cast<uint32_t>(time_s / 0.032));
}

TEST_F(RewindTest, WhatARemoteClientDidIsRepeated) {
  Start({"--body", "ideal"});
  RunTo(20);
  Ask(R"({"do":"clock","pause":false,"rate":1})");
  const uint16_t port = Ask(R"({"do":"status"})").at("rc_ports").at(0);
  {
    openr::remote::Connection client({"127.0.0.1", port}, {.timeout = std::chrono::seconds(10)});
    client.Request(rcMOVE, {1, 0xb8, 0x0b, 0, 0});  // joint 1 to 30 degrees
    client.Request(rcSENSORS);
  }
  RunTo(24);
  const OrderedJson now = Hashes();
  GoTo(21);
  GoTo(now.at("time_s"));
  EXPECT_EQ(Hashes(), now);
}

TEST_F(RewindTest, ABootIsRepeated) {
  Start({"--body", "ideal"});
  RunTo(20);
  const uint16_t port = Ask(R"({"do":"status"})").at("rc_ports").at(0);
  Ask(R"({"do":"clock","pause":false,"rate":1})");
  const double before_s = Hashes().at("time_s");
  openr::remote::Connection({"127.0.0.1", port}, {.timeout = std::chrono::seconds(10)}).Reboot();
  watcher_->WaitFor("values", [](const OrderedJson& values) {
    return values.at("robots").at(0).at("boots_at_s").is_number();
  });
  watcher_->WaitFor("values", [](const OrderedJson& values) {
    return values.at("robots").at(0).at("state") == "broadbase";
  });
  Ask(R"({"do":"clock","pause":true})");
  const OrderedJson now = Hashes();
  GoTo(before_s);
  GoTo(now.at("time_s"));
  EXPECT_EQ(Hashes(), now);
}

TEST_F(RewindTest, AViewAndABranchLeaveTheFilesOfTheRunAlone) {
  const std::string stick = folder_.path() + "/stick";
  std::filesystem::copy(OPENR_STICK, stick, std::filesystem::copy_options::recursive);
  const std::string motion = stick + "/OPEN-R/MW/DATA/P/BOW.MTN";
  Start({"--body", "ideal", "--stick", stick});
  RunTo(20);
  Ask(R"({"do":"clock","pause":false,"rate":1})");
  const uint16_t port = Ask(R"({"do":"status"})").at("rc_ports").at(0);
  ASSERT_TRUE(std::filesystem::exists(motion));
  RunTo(21);
  Ask(R"({"do":"clock","pause":false,"rate":1})");
  ProgramRun remove({"rc", "127.0.0.1:" + std::to_string(port), "mtn", "delete", "BOW.MTN"});
  EXPECT_EQ(remove.Finish().status, 0) << remove.Finish().err;
  EXPECT_FALSE(std::filesystem::exists(motion));
  RunTo(24);
  const OrderedJson now = Hashes();
  // The view of the moment before has the file, and deletes it again on the way to the present.
  GoTo(20.5);
  GoTo(now.at("time_s"));
  EXPECT_EQ(Hashes(), now);
  EXPECT_FALSE(std::filesystem::exists(motion));
  GoTo(20.5);
  Branch();
  ProgramRun list({"rc", "127.0.0.1:" + std::to_string(port), "mtn", "list"});
  EXPECT_EQ(list.Finish().status, 0) << list.Finish().err;
  EXPECT_THAT(list.Finish().out, HasSubstr("BOW.MTN"));
  EXPECT_FALSE(std::filesystem::exists(motion));
}

// The folder of the stick has a longer path than the copy of the stick that the branch has.
TEST_F(RewindTest, TheRecordingOfABranchHasWhatTheBranchChangesOnItsStick) {
  const std::string stick = folder_.path() + "/" + std::string(100, 'x') + "/stick";
  const std::string file = folder_.path() + "/run.rec";
  std::filesystem::create_directories(stick);
  std::filesystem::copy(OPENR_STICK, stick, std::filesystem::copy_options::recursive);
  Start({"--body", "ideal", "--stick", stick, "--record", file, "--for", "40s"});
  RunTo(20);
  const uint16_t port = Ask(R"({"do":"status"})").at("rc_ports").at(0);
  GoTo(19.9);
  Branch();
  Ask(R"({"do":"clock","pause":false,"rate":1})");
  ProgramRun remove({"rc", "127.0.0.1:" + std::to_string(port), "mtn", "delete", "BOW.MTN"});
  EXPECT_EQ(remove.Finish().status, 0) << remove.Finish().err;
  Ask(R"({"do":"clock","rate":0})");
  EXPECT_EQ(run_->Finish().status, 0) << run_->Finish().err;
  EXPECT_EQ(Replay(folder_.path() + "/run-2.rec"), 0);
}

// The first run has deleted a motion after the moment at which the branch begins, so the stick has
// other files than the branch.
TEST_F(RewindTest, TheRecordingOfABranchHasTheStickOfTheBranch) {
  const std::string stick = folder_.path() + "/stick", file = folder_.path() + "/run.rec";
  std::filesystem::copy(OPENR_STICK, stick, std::filesystem::copy_options::recursive);
  Start({"--body", "ideal", "--stick", stick, "--record", file, "--for", "40s"});
  RunTo(20);
  const uint16_t port = Ask(R"({"do":"status"})").at("rc_ports").at(0);
  const double before_s = Hashes().at("time_s");
  Ask(R"({"do":"clock","pause":false,"rate":1})");
  ProgramRun remove({"rc", "127.0.0.1:" + std::to_string(port), "mtn", "delete", "BOW.MTN"});
  EXPECT_EQ(remove.Finish().status, 0) << remove.Finish().err;
  GoTo(before_s);
  Branch();
  Ask(R"({"do":"clock","rate":0})");
  EXPECT_EQ(run_->Finish().status, 0) << run_->Finish().err;
  EXPECT_EQ(Replay(file), 0);
  EXPECT_EQ(Replay(folder_.path() + "/run-2.rec"), 0);
}

TEST_F(RewindTest, RefusalsSayWhy) {
  Start({"--body", "ideal"});
  RunTo(10);
  EXPECT_EQ(Error(R"({"do":"branch"})"), "no earlier moment is shown from which to go on");
  EXPECT_THAT(Error(R"({"do":"rewind","to_s":1e6})"), HasSubstr("is in the future"));
  EXPECT_THAT(Error(R"({"do":"rewind","to_s":-1})"), HasSubstr("the first checkpoint is of t="));
  EXPECT_THAT(Error(R"({"do":"rewind","to_message":100000000})"),
              HasSubstr("there have been only"));
  EXPECT_EQ(Error(R"({"do":"rewind","back_s":1})"), "none");
  EXPECT_THAT(Error(R"({"do":"input","robot":0,"line":"press chin"})"), HasSubstr("is the past"));
  EXPECT_THAT(Error(R"({"do":"clock","pause":false})"), HasSubstr("is the past"));
  EXPECT_THAT(Error(R"({"do":"sensors","robot":"first"})"),
              HasSubstr("robot: must be a whole number, is \"first\""));
}

TEST_F(RewindTest, ARunInSeveralProcessesCannotBeRewound) {
  Start({"--body", "ideal", "--isolate", "PowerMonitor"});
  const OrderedJson clock = Ask(R"({"do":"clock"})");
  EXPECT_EQ(clock.at("rewind").at("possible"), false);
  EXPECT_EQ(Error(R"({"do":"rewind","back_s":1})"),
            "this run cannot be rewound: its objects are in several processes");
}

TEST_F(RewindTest, NoCheckpointsAreLeftWhenNobodyWatches) {
  Start({"--body", "ideal"});
  RunTo(5);
  watcher_.reset();
  Watcher other(LiveRuns().at(0).socket);
  other.Ask(R"({"do":"clock","pause":false,"rate":0})");
  OrderedJson clock;
  do {
    clock = other.Ask(R"({"do":"clock"})");
    ASSERT_FALSE(clock.is_null());
  } while (clock.at("rewind").at("checkpoints") > 0);
}

TEST_F(RewindTest, SigtermEndsTheBranch) {
  Start({"--body", "ideal"});
  RunTo(20);
  EXPECT_EQ(Error(R"({"do":"rewind","back_s":1})"), "none");
  Branch();
  run_->WaitFor("ended by branch");
  run_->Signal(SIGTERM);
  const ProgramResult& result = run_->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("ended by pause"));
}

}  // namespace
}  // namespace openr_host
