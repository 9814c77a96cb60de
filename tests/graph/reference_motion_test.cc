// The vendor's own motions, read where OPENR_MTN_REFERENCE names their folder; they are
// no part of the project.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "MtnFile.h"
#include "tests/graph/graph.h"
#include "virtualrobot/base/rotation.h"
#include "virtualrobot/body/kinematics.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = 57.29577951308232;

class ReferenceMotionTest : public testing::Test {
 protected:
  void SetUp() override {
    const char* const folder = std::getenv("OPENR_MTN_REFERENCE");
    if (folder == nullptr || !fs::is_directory(folder)) {
      GTEST_SKIP() << "OPENR_MTN_REFERENCE names no folder";
    }
    reference_ = folder;
    stick_ = fs::temp_directory_path() / fmt::format("openr-reference-{}", getpid());
    fs::remove_all(stick_);
    fs::copy(OPENR_STICK, stick_, fs::copy_options::recursive);
    for (const auto& entry : fs::directory_iterator(reference_)) {
      if (entry.path().extension() == ".MTN") {
        fs::copy_file(entry.path(), stick_ / "OPEN-R/MW/DATA/P" / entry.path().filename(),
                      fs::copy_options::overwrite_existing);
      }
    }
  }
  void TearDown() override {
    if (!stick_.empty()) fs::remove_all(stick_);
  }

  MtnFile Load(const std::string& name) const {
    std::ifstream file(reference_ / name, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
    MtnFile motion;
    EXPECT_TRUE(motion.Read(reinterpret_cast<const Uint8*>(bytes.data()), bytes.size()))
        << name << ": " << motion.Error();
    return motion;
  }

  // Plays `name` and checks that the last commanded frame is the last key frame, exactly.
  void Play(Graph* graph, const std::string& name, int loops = 1) {
    graph->pilot().Play(name, loops);
    ASSERT_TRUE(
        graph->system().RunUntil([&] { return graph->pilot().MotionIsOver(); }, 120'000'000))
        << name;
    MtnFile motion = Load(name);
    ASSERT_TRUE(motion.MapTo(FindRobot("ERS-210"))) << motion.Error();
    for (int j = 0; j < motion.NumJoints(); ++j) {
      const auto joint = static_cast<size_t>(motion.RobotJoint(j));
      EXPECT_EQ(graph->dog().devices().joints[joint].target_urad,
                motion.Angle(motion.NumKeyFrames() - 1, j))
          << name << " " << motion.Locator(j);
    }
    EXPECT_FALSE(graph->system().findings().HasError()) << graph->Findings();
  }

  // |roll| < 20 and pitch within 15 degrees of what kinematics gives for the set points.
  void ExpectUpright(Graph* graph, const std::string& name) {
    graph->system().RunFor(300'000);
    std::vector<double> angles;
    for (const JointDevice& joint : graph->dog().devices().joints) {
      angles.push_back(joint.target_urad * 1e-6);
    }
    const RestingPose pose = PlaceOnFloor(graph->model(), angles);
    EXPECT_LT(std::abs(graph->RollDeg()), 20) << name;
    EXPECT_NEAR(graph->PitchDeg(), RpyOf(pose.X_WB.linear()).y() * kDegree, 15) << name;
  }

  // A dog that stands, and sits if the motion wants it to.
  std::unique_ptr<Graph> ReadyFor(const std::string& name) {
    auto graph = std::make_unique<Graph>(OnStick(stick_));
    EXPECT_TRUE(graph->RunToStanding());
    if (Load(name).Name().starts_with("a_sit#")) Play(graph.get(), "STANDSIT.MTN");
    return graph;
  }

  fs::path reference_;
  fs::path stick_;
};

TEST_F(ReferenceMotionTest, EveryErs210FilePlaysToItsLastKeyFrameAndTheDogStaysUpright) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(reference_)) {
    const std::string name = entry.path().filename();
    const MtnFile motion = Load(name);
    if (motion.NumJoints() != 15) continue;
    SCOPED_TRACE(name + " " + motion.Name());
    const std::unique_ptr<Graph> graph = ReadyFor(name);
    Play(graph.get(), name);
    ++count;
    if (!motion.Name().starts_with("a_sleep#sleep") &&
        !motion.Name().ends_with("#sleep_standard")) {
      ExpectUpright(graph.get(), name);
    }
  }
  EXPECT_GE(count, 13);
}

TEST_F(ReferenceMotionTest, TheWalkGoesForwardAndHardlySideways) {
  const std::unique_ptr<Graph> graph = ReadyFor("SWSDK.MTN");
  const Eigen::Vector3d start = graph->dog().body().state().X_WB.translation();
  Play(graph.get(), "SWSDK.MTN");
  Play(graph.get(), "WWFWD.MTN", 5);
  const Eigen::Vector3d way = graph->dog().body().state().X_WB.translation() - start;
  EXPECT_GE(way.x(), 0.150);
  EXPECT_LT(std::abs(way.y()), 0.100);
}

TEST_F(ReferenceMotionTest, FilesOfTheErs7AreRefusedByTheirLocators) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(reference_)) {
    const std::string name = entry.path().filename();
    MtnFile motion = Load(name);
    if (motion.NumJoints() != 20) continue;
    SCOPED_TRACE(name);
    EXPECT_FALSE(motion.MapTo(FindRobot("ERS-210")));
    EXPECT_NE(motion.Error().find("PRM:/"), std::string::npos) << motion.Error();
    ++count;
  }
  EXPECT_GE(count, 6);
}

}  // namespace
}  // namespace openr_host
