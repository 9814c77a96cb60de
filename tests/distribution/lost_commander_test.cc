// A free run whose JointMover is killed: the joints hold and then move to the sleeping posture;
// messages to JointMover are counted.
#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "tests/distribution/kill_process.h"
#include "tests/distribution/ros2/ros2_run.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

// The times of docs/distribution.md; at first a vector may still be on its way.
constexpr int64_t kUnderWay_us = 300'000;
constexpr int64_t kHold_us = 2'000'000;
constexpr int64_t kAtRest_us = 6'000'000;

class LostCommanderTest : public testing::Test {
 protected:
  // Returns positions by virtual time, read until some time after `begin_us`.
  std::map<int64_t, std::vector<double>> PositionsUntil(int64_t begin_us, int64_t length_us) {
    std::map<int64_t, std::vector<double>> heard;
    while (heard.empty() || heard.rbegin()->first < begin_us + length_us) {
      for (const json& state :
           run_.peer().Read("sensor_msgs/JointState", "rt/aibo/joint_states", 5))
        heard[state.at("stamp_us")] = state.at("position").get<std::vector<double>>();
    }
    return heard;
  }
  int64_t Now_us() { return run_.peer().ReadOne("rosgraph_msgs/Clock", "rt/clock")["stamp_us"]; }

  Ros2Run run_{{"--isolate", "JointMover", "--free-running", "--body", "ideal", "--json"}, "3"};
};

TEST_F(LostCommanderTest, JointsHoldAndThenGoToTheSleepingPosture) {
  run_.WaitUntil(12'000'000);  // the dog stands by then
  const std::vector<pid_t> children = ChildrenOf(run_.program().pid());
  ASSERT_EQ(children.size(), 1u);
  KillProcess(children[0], SIGKILL);
  ASSERT_TRUE(run_.program().WaitFor("was killed by signal 9")) << run_.program().heard();
  const auto heard = PositionsUntil(Now_us(), kAtRest_us + 500'000);
  const ProgramResult& result = run_.End();
  EXPECT_EQ(result.status, 1) << result.err;
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  EXPECT_THAT(report["processes"][0]["lost"].get<std::string>(),
              testing::HasSubstr("was killed by signal 9"));
  int64_t lost_us = 0;
  for (const json& finding : report["findings"]) {
    const std::string text = finding["text"];
    if (text.find("was killed by") != std::string::npos)
      lost_us = std::llround(finding["time_s"].get<double>() * 1e6);
  }
  ASSERT_GT(lost_us, 0) << report["findings"];

  const RobotModel model = LoadRobotModel(OPENR_MODEL_DIR "/ers210.json");
  const std::vector<double> rest = model.PostureAngles("sleep");
  const auto first = heard.lower_bound(lost_us + kUnderWay_us);
  const auto moves = heard.lower_bound(lost_us + kHold_us);
  const auto last = std::prev(heard.end());
  ASSERT_LT(first->first, moves->first) << "nothing was heard while they were to hold";
  ASSERT_EQ(rest.size(), last->second.size());
  double way = 0;
  for (size_t i = 0; i < rest.size(); ++i) {
    for (auto at = first; at != moves; ++at)
      EXPECT_NEAR(at->second[i], first->second[i], 1e-6) << model.joints[i].name;
    EXPECT_NEAR(last->second[i], rest[i], 0.02) << model.joints[i].name;
    way = std::max(way, std::abs(first->second[i] - rest[i]));
  }
  EXPECT_GT(way, 0.5) << "they were there before";
}

}  // namespace
}  // namespace openr_host
