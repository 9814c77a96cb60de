// Motions on the body: our own always, the vendor's where the folder exists.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "MtnFile.h"
#include "tests/graph/graph.h"
#include "tests/objects/mtn_bytes.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Plays a motion of the stick to its end.
void Play(Graph& graph, const std::string& file, int loops = 1) {
  graph.pilot().Play(file, loops);
  ASSERT_TRUE(graph.system().RunUntil([&] { return graph.pilot().MotionIsOver(); }, 60'000'000))
      << file;
  EXPECT_FALSE(graph.system().findings().HasError()) << graph.Findings();
}

TEST(MotionTest, AJointGoesWhereItIsToldAndStops) {
  WhenStanding({}, [](Graph& graph) {
    const int pan = graph.model().FindJoint("neck_pan");
    graph.pilot().Send(moverkindPOSITION, pan, 523599);  // 30 degrees
    graph.system().RunFor(3'000'000);
    EXPECT_NEAR(graph.JointDeg("neck_pan"), 30, 2);
  });
}

TEST(MotionTest, ACommandBeyondTheLimitEndsAtTheLimit) {
  WhenStanding({}, [](Graph& graph) {
    const int pan = graph.model().FindJoint("neck_pan");
    graph.pilot().Send(moverkindPOSITION, pan, 3000000);
    graph.system().RunFor(6'000'000);
    EXPECT_NEAR(graph.JointDeg("neck_pan"), 89.6, 2);
  });
}

TEST(MotionTest, OurOwnMotionsEndAsTheyShould) {
  WhenStanding({}, [](Graph& graph) {
    Play(graph, "SIT.MTN");
    graph.system().RunFor(500'000);
    EXPECT_LT(graph.PitchDeg(), -15);  // nose up
    EXPECT_NEAR(graph.RollDeg(), 0, 10);
    Play(graph, "STAND.MTN");
    EXPECT_TRUE(graph.Standing());
    Play(graph, "BOW.MTN");
    EXPECT_TRUE(graph.Standing());
    Play(graph, "LIE.MTN");
    graph.system().RunFor(500'000);
    EXPECT_LT(graph.dog().body().state().X_WB.translation().z(), 0.09);
    EXPECT_NEAR(graph.RollDeg(), 0, 10);
  });
}

TEST(MotionTest, OurWalkIsAtLeastFortyMillimetresASecond) {
  WhenStanding({}, [](Graph& graph) {
    Play(graph, "WALKSTA.MTN");
    const Eigen::Vector3d start = graph.dog().body().state().X_WB.translation();
    const int64_t begin_us = graph.system().now_us();
    Play(graph, "WALK.MTN", 8);
    const double seconds = static_cast<double>(graph.system().now_us() - begin_us) * 1e-6;
    const Eigen::Vector3d way = graph.dog().body().state().X_WB.translation() - start;
    EXPECT_GE(way.x() / seconds, 0.040) << "in " << seconds << " s";
    EXPECT_LT(std::abs(way.y()), 0.1);
    Play(graph, "WALKEND.MTN");
    graph.system().RunFor(1'000'000);
    EXPECT_TRUE(graph.Standing());
  });
}

// The largest minus the smallest value of an accelerometer during a second, in m/s^2.
double SpreadOf(Graph& graph, const char* sensor) {
  int64_t low = graph.SensorValue(sensor), high = low;
  for (int frame = 0; frame < 125; ++frame) {
    graph.system().RunFor(8'000);
    low = std::min(low, graph.SensorValue(sensor));
    high = std::max(high, graph.SensorValue(sensor));
  }
  return static_cast<double>(high - low) * 1e-6;
}

// field-notes.md 8.6.
TEST(MotionTest, AWalkShakesTheAccelerometersTooMuchForDirectUse) {
  WhenStanding({}, [](Graph& graph) {
    constexpr const char* kSensors[] = {"acceleration_x", "acceleration_y", "acceleration_z"};
    for (const char* sensor : kSensors) EXPECT_LT(SpreadOf(graph, sensor), 0.2) << sensor;
    graph.pilot().Play("WALK.MTN", 8);
    graph.system().RunFor(2'500'000);  // the dog goes to the first key frame before
    // A slope of 10 degrees, which a program may want to measure, changes a value by 1.7 m/s^2.
    for (const char* sensor : kSensors) EXPECT_GT(SpreadOf(graph, sensor), 3) << sensor;
    EXPECT_FALSE(graph.pilot().MotionIsOver());
  });
}

TEST(MotionTest, TheLastCommandedFrameIsTheLastKeyFrame) {
  WhenStanding(kIdeal, [](Graph& graph) {
    Play(graph, "SIT.MTN");
    graph.system().RunFor(100'000);
    const fs::path path = fs::path(OPENR_STICK) / "OPEN-R/MW/DATA/P/SIT.MTN";
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
    MtnFile motion;
    ASSERT_TRUE(motion.Read(reinterpret_cast<const Uint8*>(bytes.data()), bytes.size()))
        << motion.Error();
    ASSERT_TRUE(motion.MapTo(FindRobot("ERS-210"))) << motion.Error();
    for (int j = 0; j < motion.NumJoints(); ++j) {
      const auto joint = static_cast<size_t>(motion.RobotJoint(j));
      EXPECT_EQ(graph.dog().devices().joints[joint].target_urad,
                motion.Angle(motion.NumKeyFrames() - 1, j))
          << motion.Locator(j);
    }
  });
}

// Head and ears: the left ear goes on with key frame 1 and off with key frame 2, the right one
// stays off.
TEST(MotionTest, EarsOfAMotionGoUpAndDownWithItsKeyFrames) {
  WhenStanding(kIdeal, [](Graph& graph) {
    MtnBytes mtn;
    mtn.locators = {"PRM:/r1/c1/c2-Joint2:j2", "PRM:/r1/c1/c2/c3/e1-Joint3:j5",
                    "PRM:/r1/c1/c2/c3/e2-Joint3:j6"};
    mtn.key_frames = {{0, {0, 0, 0}}, {30, {100'000, 1, 0}}, {60, {200'000, 0, 0}}};
    const std::vector<uint8_t> bytes = mtn.Bytes();
    graph.stick().Write("/MS/OPEN-R/MW/DATA/P/EARS.MTN", std::string(bytes.begin(), bytes.end()));
    std::string left;  // states, as they change
    graph.OnMessage([&](const openr::testing::SeenMessage&) {
      const auto& ears = graph.dog().devices().plungers;
      EXPECT_EQ(ears[1].state, ojoint3_STATE0);
      const char state = ears[0].state == ojoint3_STATE1 ? '1' : '0';
      if (left.empty() || left.back() != state) left += state;
    });
    Play(graph, "EARS.MTN");
    graph.system().RunFor(200'000);
    EXPECT_EQ(left, "010");
    EXPECT_EQ(graph.Findings(), "");
  });
}

TEST(MotionTest, AMissingMotionIsRefusedAndTheDogGoesOn) {
  WhenStanding(kIdeal, [](Graph& graph) {
    graph.pilot().Play("NOTHERE.MTN");
    EXPECT_TRUE(graph.system().RunUntil([&] { return graph.pilot().MotionIsOver(); }, 1'000'000));
    EXPECT_NE(graph.console().find("motion not played"), std::string::npos) << graph.console();
    Play(graph, "SIT.MTN");
  });
}

}  // namespace
}  // namespace openr_host
