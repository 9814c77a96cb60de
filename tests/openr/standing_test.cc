#include "openr/simulation/standing.h"

#include <gtest/gtest.h>

#include "cli/install_paths.h"
#include "virtualrobot/base/rotation.h"
#include "virtualrobot/body/kinematics.h"

namespace openr_host {
namespace {

constexpr int64_t kFrame = 8000;

class StandingTest : public testing::Test {
 protected:
  StandingTest() : model_(LoadRobotModel(ModelFile("ers210"))), monitor_(model_) {
    Rest(model_.PostureAngles("stand"));
  }

  // Puts the robot, stiff at `angles_rad`, on a flat floor.
  void Rest(const std::vector<double>& angles_rad) {
    const RestingPose rest = PlaceOnFloor(model_, angles_rad);
    state_.X_WB = rest.X_WB;
    state_.paws = rest.paws;
    state_.joints.resize(angles_rad.size());
    for (size_t i = 0; i < angles_rad.size(); ++i) state_.joints[i].angle_rad = angles_rad[i];
  }

  // Turns joint `name` of all four legs by `degrees`.
  void TurnInAllLegs(const std::string& name, double degrees) {
    for (const char* leg : {"LF_", "LH_", "RF_", "RH_"}) {
      const int joint = model_.FindJoint(leg + name);
      ASSERT_GE(joint, 0) << leg << name;
      state_.joints[static_cast<size_t>(joint)].angle_rad += Radians(degrees);
    }
  }

  // Shows the same state for `us`.
  bool After(int64_t us) {
    for (int64_t end = now_us_ + us; now_us_ < end; now_us_ += kFrame) {
      monitor_.Sample(state_, now_us_);
    }
    monitor_.Sample(state_, now_us_);
    return monitor_.standing();
  }

  const RobotModel model_;
  StandingMonitor monitor_;
  BodyState state_;
  int64_t now_us_ = 0;
};

TEST_F(StandingTest, HalfASecondOfCalmInTheStandingPostureIsStanding) {
  EXPECT_FALSE(After(400'000));
  EXPECT_TRUE(After(120'000));
}

TEST_F(StandingTest, NobodyStandsBeforeTheFirstFrame) { EXPECT_FALSE(monitor_.standing()); }

TEST_F(StandingTest, APawInTheAirIsNotStanding) {
  state_.paws[2] = false;
  EXPECT_FALSE(After(1'000'000));
}

// Joint j3 stretches or bends the leg, and moves its paw forward or back as well.
TEST_F(StandingTest, ALegBentMuchMoreIsNotStanding) {
  TurnInAllLegs("j3", 3);
  EXPECT_TRUE(After(1'000'000));
  TurnInAllLegs("j3", 25);
  EXPECT_FALSE(After(1'000'000));
}

TEST_F(StandingTest, ALeftSideThatIsLowerThanThreeDegreesIsNotStanding) {
  for (const char* leg : {"LF_j3", "LH_j3"}) {
    state_.joints[static_cast<size_t>(model_.FindJoint(leg))].angle_rad += Radians(40);
  }
  EXPECT_FALSE(After(1'000'000));
}

TEST_F(StandingTest, TheHeightOfTheGroundDoesNotMatter) {
  state_.X_WB.translation().z() += 0.3;
  EXPECT_TRUE(After(1'000'000));
}

TEST_F(StandingTest, ASlopeOfTwentyDegreesIsGroundToStandOn) {
  const Eigen::Matrix3d flat = state_.X_WB.linear();
  state_.X_WB.linear() = RotationFromRpy({0, Radians(-19), 0}) * flat;
  EXPECT_TRUE(After(1'000'000));
  state_.X_WB.linear() = RotationFromRpy({0, Radians(-21), 0}) * flat;
  EXPECT_FALSE(After(1'000'000));
  state_.X_WB.linear() = RotationFromRpy({Radians(180), 0, 0}) * flat;
  EXPECT_FALSE(After(1'000'000));
}

TEST_F(StandingTest, TheHeadingDoesNotMatter) {
  state_.X_WB.linear() = RotationFromRpy({0, 0, 1.0}) * state_.X_WB.linear();
  EXPECT_TRUE(After(1'000'000));
}

TEST_F(StandingTest, AMovementStartsTheHalfSecondAgain) {
  EXPECT_TRUE(After(1'000'000));
  state_.v_WB.x() = 0.006;
  EXPECT_FALSE(After(kFrame));
  state_.v_WB.x() = 0.004;
  EXPECT_FALSE(After(400'000));
  EXPECT_TRUE(After(120'000));
}

}  // namespace
}  // namespace openr_host
