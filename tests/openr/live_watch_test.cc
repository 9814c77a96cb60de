// Watching a run through its socket, pausing it and making steps.
#include <gmock/gmock.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "openr/live/live_folder.h"
#include "runtime/base/read_file.h"
#include "runtime/base/temp_folder.h"
#include "tests/openr/program_run.h"
#include "tests/openr/watcher.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

constexpr char kAllEvents[] = R"(["clock","pose","values","graph","findings","log"])";

class LiveWatchTest : public ::testing::Test {
 protected:
  LiveWatchTest() { setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1); }
  ~LiveWatchTest() override { unsetenv("XDG_RUNTIME_DIR"); }

  std::unique_ptr<ProgramRun> Start(std::vector<std::string> flags = {}) {
    std::vector<std::string> arguments = {"run",    "--rc-port", "0",          "--no-panel",
                                          "--body", "ideal",     "--run-name", "seen"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    auto run = std::make_unique<ProgramRun>(arguments);
    EXPECT_TRUE(run->WaitFor("remote control"));
    return run;
  }

  std::unique_ptr<Watcher> Watch(const std::string& events = kAllEvents) {
    auto watcher = std::make_unique<Watcher>(LiveRuns().at(0).socket);
    const Json answer = watcher->Ask(R"({"do":"watch","period_ms":16,"events":)" + events + "}");
    EXPECT_EQ(answer.value("watching", false), true) << answer;
    return watcher;
  }

  const TempFolder folder_;
};

TEST_F(LiveWatchTest, TheEventsDescribeTheRobotsOfTheScene) {
  const auto run = Start({"--robots", "2"});
  Watcher asker(LiveRuns().at(0).socket);
  const Json scene = asker.Ask(R"({"do":"scene"})");
  ASSERT_EQ(scene.at("robots").size(), 2u);
  EXPECT_EQ(scene.at("model"), "ERS-210");
  const auto watcher = Watch();
  const Json pose = watcher->WaitFor("pose"), values = watcher->WaitFor("values");
  for (size_t i = 0; i < 2; ++i) {
    const Json& robot = scene.at("robots")[i];
    EXPECT_EQ(pose.at("robots")[i].at("links").size(), robot.at("links").size());
    EXPECT_EQ(pose.at("robots")[i].at("leds").size(), robot.at("leds").size());
    EXPECT_EQ(pose.at("robots")[i].at("ears").size(), robot.at("ears").size());
    EXPECT_EQ(values.at("robots")[i].at("joints").size(), robot.at("joints").size());
    EXPECT_EQ(values.at("robots")[i].at("sensors").size(), robot.at("sensors").size());
  }
  std::vector<std::string> touched;
  for (const Json& link : scene.at("robots")[0].at("links")) {
    for (const Json& shape : link.at("shapes")) {
      if (shape.contains("touch")) touched.push_back(shape.at("touch"));
    }
  }
  EXPECT_THAT(touched, ::testing::UnorderedElementsAre("back", "chin", "head_back", "head_front",
                                                       "paw_LF", "paw_LH", "paw_RF", "paw_RH"));
}

TEST_F(LiveWatchTest, AWatchedRunIsTheSameRun) {
  const std::string watched = folder_.path() + "/watched.json", alone = folder_.path() + "/a.json";
  {
    const auto run = Start({"--for", "20s", "--rate", "10", "--report", watched});
    const auto watcher = Watch();
    while (!watcher->Next().is_null()) {
    }
    EXPECT_EQ(run->Finish().status, 0);
  }
  const auto run = Start({"--for", "20s", "--rate", "max", "--report", alone});
  EXPECT_EQ(run->Finish().status, 0);
  const Json with = Json::parse(*ReadFile(watched)), without = Json::parse(*ReadFile(alone));
  EXPECT_EQ(with.at("trace_hash"), without.at("trace_hash"));
  EXPECT_EQ(with.at("state_hash"), without.at("state_hash"));
}

TEST_F(LiveWatchTest, APausedRunMakesTheStepsThatAreAskedFor) {
  const std::string file = folder_.path() + "/run.rec";
  const auto run = Start({"--record", file});
  const auto watcher = Watch(R"(["clock"])");
  watcher->Ask(R"({"do":"clock","pause":true})");
  const Json before = watcher->Ask(R"({"do":"clock"})");
  EXPECT_EQ(before.at("paused"), true);
  const auto after = [&](const std::string& request) {
    const double time_s = watcher->Ask(R"({"do":"clock"})").at("time_s");
    const uint64_t messages = watcher->Ask(R"({"do":"clock"})").at("messages");
    EXPECT_FALSE(watcher->Ask(request).contains("error"));
    return watcher->WaitFor("clock", [&](const Json& clock) {
      return clock.at("time_s") > time_s || clock.at("messages") > messages;
    });
  };
  const double time_s = before.at("time_s");
  const Json frame = after(R"({"do":"clock","step":"frame","count":1})");
  EXPECT_NEAR(frame.at("time_s"), time_s + 0.008, 1e-9);
  const Json message = after(R"({"do":"clock","step":"message"})");
  EXPECT_EQ(message.at("messages"), frame.at("messages").get<uint64_t>() + 1);
  // Sensor values come every 32 ms.
  const double first_s = after(R"({"do":"clock","step":"vector"})").at("time_s");
  EXPECT_LE(first_s, time_s + 0.048);
  after(R"({"do":"clock","step":"frame","count":2})");
  const Json second = after(R"({"do":"clock","step":"vector"})");
  EXPECT_EQ(std::lround((second.at("time_s").get<double>() - first_s) * 1000) % 32, 0);
  watcher->Ask(R"({"do":"clock","pause":false,"rate":0})");
  ASSERT_FALSE(
      watcher->WaitFor("clock", [&](const Json& clock) { return clock.at("time_s") > time_s + 5; })
          .is_null());
  watcher->Ask(R"({"do":"input","robot":0,"line":"press pause"})");
  EXPECT_EQ(run->Finish().status, 0);
  ProgramRun replay({"replay", file});
  EXPECT_EQ(replay.Finish().status, 0) << replay.Finish().err;
}

TEST_F(LiveWatchTest, WrongRequestsAboutTheClockSayWhy) {
  const auto run = Start();
  Watcher watcher(LiveRuns().at(0).socket);
  const auto error = [&](const std::string& request) {
    return watcher.Ask(request).value("error", "no error");
  };
  EXPECT_EQ(error(R"({"do":"clock","rate":-1})"),
            "the rate -1 is neither 0, as fast as possible, nor 0.001 to 1000");
  EXPECT_EQ(error(R"({"do":"clock","step":"leap"})"),
            "a step is frame, message or vector, not 'leap'");
  EXPECT_EQ(error(R"({"do":"clock","step":"frame","count":0})"),
            "request: count: is 0, must be 1 to 1000");
  EXPECT_EQ(error(R"({"do":"connection","connection":"0:A>B"})"), "there is no connection '0:A>B'");
  EXPECT_EQ(error(R"({"do":"clock","rate":2})"), "no error");
}

TEST_F(LiveWatchTest, RefusalsNameTheMemberAndWhatIsAllowed) {
  const auto run = Start();
  Watcher watcher(LiveRuns().at(0).socket);
  const auto error = [&](const std::string& request) {
    return watcher.Ask(request).value("error", "no error");
  };
  EXPECT_EQ(error("{}"), "request: 'do' is missing");
  EXPECT_EQ(error(R"({"do":5})"), "request: do: must be a text, is 5");
  EXPECT_THAT(error("{"), ::testing::StartsWith("the request is no JSON: parse error at line 1"));
  EXPECT_EQ(error(R"({"do":"watch"})"), "request: 'events' is missing");
  EXPECT_EQ(error(R"({"do":"watch","events":7})"), "request: events: must be a list, is 7");
  EXPECT_EQ(error(R"({"do":"watch","events":"pose"})"),
            "request: events: must be a list, is \"pose\"");
  EXPECT_EQ(error(R"({"do":"watch","events":["poses"]})"),
            "request: events[0]: there is no event 'poses'; known are clock, pose, values, graph, "
            "findings, log");
  EXPECT_EQ(error(R"({"do":"watch","events":["pose"],"period_ms":-5})"),
            "request: period_ms: is -5, must be 8 to 1000");
  EXPECT_EQ(error(R"({"do":"input","line":7})"), "request: line: must be a text, is 7");
  EXPECT_EQ(error(R"({"do":"joints","robot":1.5})"),
            "request: robot: must be a whole number, is 1.5");
  EXPECT_EQ(error(R"({"do":"inputs","robot":1})"), "there is no robot 1; this run has 1");
  EXPECT_EQ(error(R"({"do":"clock","pause":1})"), "request: pause: must be true or false, is 1");
  EXPECT_EQ(error(R"({"do":"rewind"})"),
            "request: 'rewind' needs 'to_s', 'to_message', 'back_s' or 'present'");
}

TEST_F(LiveWatchTest, TypedTextThatNoProgramReadsIsRefusedInTheEnd) {
  const auto run = Start();
  Watcher watcher(LiveRuns().at(0).socket);
  const std::string request = R"({"do":"input","line":"type )" + std::string(40'000, 'a') + R"("})";
  EXPECT_FALSE(watcher.Ask(request).contains("error"));
  EXPECT_THAT(watcher.Ask(request).value("error", ""),
              HasSubstr("no program of the robot reads the console"));
}

TEST_F(LiveWatchTest, OnlyARobotOfTheRunCanBeCoupled) {
  const auto run = Start();
  Watcher watcher(LiveRuns().at(0).socket);
  const auto couple = [&](const std::string& robot) {
    return watcher.Ask(R"({"do":"couple","with":"127.0.0.1:1","robot":)" + robot + "}");
  };
  EXPECT_EQ(couple("7"), Json({{"error", "there is no robot 7; this run has 1"}}));
  EXPECT_EQ(couple("-1"), Json({{"error", "there is no robot -1; this run has 1"}}));
  EXPECT_EQ(couple("0.5"), Json({{"error", "request: robot: must be a whole number, is 0.5"}}));
  EXPECT_EQ(couple("0").at("coupled"), true);
}

TEST_F(LiveWatchTest, AConnectionShowsItsLastMessagesInWords) {
  const auto run = Start({"--rate", "max"});
  const auto watcher = Watch(R"(["graph","values"])");
  watcher->WaitFor("values", [](const Json& values) {
    return values.at("robots")[0].at("state") == "accepting-commands";
  });
  const auto messages_of = [&](const std::string& id) {
    return watcher->Ask(R"({"do":"connection","connection":")" + id + "\"}").at("messages").dump();
  };
  EXPECT_THAT(messages_of("0:JointMover.MainExecution.MainExecutionMessage.S>"
                          "Controller.MainExecution.MainExecutionMessage.O"),
              HasSubstr("state accepting-commands"));
  EXPECT_THAT(messages_of("0:OVirtualRobotComm.Sensor.OSensorFrameVectorData.S>"
                          "RCServer.Sensor.OSensorFrameVectorData.O"),
              HasSubstr("PRM:/r1/c1/c2-Joint2:j2 "));
  const Json graph = watcher->WaitFor(
      "graph", [](const Json& event) { return event.at("connections")[10].at("per_s") > 0; });
  EXPECT_NEAR(graph.at("connections")[10].at("per_s"), 62.5, 1);  // 31.25 vectors, 31.25 readies
}

TEST_F(LiveWatchTest, ASlowClientGetsFewerEventsAndNotOldOnes) {
  const auto run = Start({"--rate", "max"});
  const auto slow = Watch(R"(["pose","graph"])");
  const auto other = Watch(R"(["clock"])");
  // The slow client reads nothing, so its socket fills, while the run goes on.
  const Json later =
      other->WaitFor("clock", [](const Json& clock) { return clock.at("time_s") > 200; });
  ASSERT_FALSE(later.is_null());
  double last_s = 0;
  for (int i = 0; i < 100'000 && last_s < 200; ++i) {
    const Json event = slow->WaitFor("pose");
    ASSERT_FALSE(event.is_null());
    last_s = event.at("time_s");
  }
  EXPECT_GT(last_s, 200);
}

}  // namespace
}  // namespace openr_host
