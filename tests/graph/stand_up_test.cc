// The dog stands up by itself.
#include <gtest/gtest.h>

#include <string>

#include "tests/graph/graph.h"

namespace openr_host {
namespace {

TEST(StandUpTest, GoesThroughTheStatesOfTheReportAndStands) {
  Graph graph;
  ASSERT_TRUE(graph.RunToStanding()) << graph.console() << graph.Findings();
  const std::vector<std::string> expected = {
      "filling", "gains", "broadbase", "sleeping", "crouching", "standing", "accepting-commands"};
  const std::vector<std::string> states = graph.MoverStates();
  std::vector<std::string> mover_states;
  for (const std::string& state : states) {
    for (const std::string& name : expected) {
      if (state == name) mover_states.push_back(state);
    }
  }
  EXPECT_EQ(mover_states, expected);
  EXPECT_TRUE(graph.Standing());
  EXPECT_NEAR(graph.RollDeg(), 0, 2);
  EXPECT_NEAR(graph.PitchDeg(), 2.6, 2);
  for (const bool paw : graph.dog().body().state().paws) EXPECT_TRUE(paw);
  EXPECT_FALSE(graph.system().findings().HasError()) << graph.Findings();
  EXPECT_LE(graph.system().now_us(), 20'000'000);
}

TEST(StandUpTest, EveryJointEndsWhereThePostureWantsIt) {
  WhenStanding({}, [](Graph& graph) {
    graph.system().RunFor(1'000'000);
    const RobotModel& model = graph.model();
    const std::vector<double>& wanted = model.PostureAngles("stand");
    for (size_t i = 0; i < model.joints.size(); ++i) {
      const std::string& name = model.joints[i].name;
      if (name.starts_with("tail")) continue;  // the default controller wags it
      EXPECT_NEAR(graph.JointDeg(name), wanted[i] * 57.29577951308232, 2.0) << name;
    }
  });
}

TEST(StandUpTest, ObjectsThatDoNotKnowTheRobotGoOn) {
  openr::testing::Bench bench({.stick = OPENR_STICK, .body = "ideal"});
  bench.system().robot(0).design = "ERS-1000";
  bench.Boot();
  bench.system().RunFor(2'000'000);
  for (const char* const object : {"JointMover", "RCServer", "Controller"}) {
    EXPECT_NE(bench.console().find(std::string(object) +
                                   ": robot design 'ERS-1000' is not in RobotConstants"),
              std::string::npos)
        << bench.console();
  }
  bench.PressPause();  // the objects stop, too
  bench.system().RunFor(1'000'000);
  EXPECT_TRUE(bench.system().powered_off());
}

TEST(StandUpTest, TheOtherModelsStandToo) {
  for (const char* const robot : {"ers220", "ers7"}) {
    GraphOptions options;
    options.robot = robot;
    Graph graph(options);
    ASSERT_TRUE(graph.RunToStanding()) << robot << graph.console() << graph.Findings();
    EXPECT_TRUE(graph.Standing()) << robot;
    EXPECT_NEAR(graph.RollDeg(), 0, 1) << robot;
    for (const bool paw : graph.dog().body().state().paws) EXPECT_TRUE(paw) << robot;
    graph.system().RunFor(1'000'000);  // the controller begins when the dog stands
    EXPECT_EQ(graph.Findings().find("robot_get_device"), std::string::npos)
        << robot << graph.Findings();
    EXPECT_FALSE(graph.system().findings().HasError()) << robot << graph.Findings();
  }
}

TEST(StandUpTest, TheIdealBodyStandsToo) {
  Graph graph(kIdeal);
  ASSERT_TRUE(graph.RunToStanding()) << graph.console() << graph.Findings();
  EXPECT_NEAR(graph.PitchDeg(), 2.6, 0.2);
  EXPECT_FALSE(graph.system().findings().HasError()) << graph.Findings();
}

TEST(StandUpTest, TheDefaultControllerLightsEyesAndWagsTheTail) {
  WhenStanding({}, [](Graph& graph) {
    double low = 1e9;
    double high = -1e9;
    bool lit = false;
    bool dark = false;
    for (int frame = 0; frame < 500; ++frame) {
      graph.system().RunFor(kFrameUs);
      low = std::min(low, graph.JointDeg("tail_pan"));
      high = std::max(high, graph.JointDeg("tail_pan"));
      (graph.dog().devices().leds[0].intensity != 0 ? lit : dark) = true;
    }
    EXPECT_TRUE(lit);
    EXPECT_TRUE(dark);
    EXPECT_GT(high - low, 5.0);
  });
}

TEST(StandUpTest, ThePauseButtonEndsInStopAndDestroyThroughPowerMonitor) {
  WhenStanding(kIdeal, [](Graph& graph) {
    graph.dog().PressPause();
    graph.system().RunFor(1'000'000);
    EXPECT_TRUE(graph.system().powered_off());
    EXPECT_EQ(graph.dog().power().next_boot.bitmap, obcbPAUSE_SW);
  });
}

}  // namespace
}  // namespace openr_host
