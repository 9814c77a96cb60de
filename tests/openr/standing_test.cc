#include "openr/simulation/standing.h"

#include <gtest/gtest.h>

#include "cli/install_paths.h"
#include "virtualrobot/kinematics.h"

namespace openr_host {
namespace {

constexpr int64_t kFrame = 8000;

class StandingTest : public testing::Test {
 protected:
  StandingTest() : model_(LoadRobotModel(ModelFile("ers210"))), monitor_(model_) {
    const RestingPose rest = PlaceOnFloor(model_, model_.PostureAngles("stand"));
    state_.X_WB = rest.X_WB;
    state_.paws = rest.paws;
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

TEST_F(StandingTest, HeightMayDifferByTenMillimetres) {
  state_.X_WB.translation().z() += 0.0099;
  EXPECT_TRUE(After(1'000'000));
  state_.X_WB.translation().z() += 0.0002;
  EXPECT_FALSE(After(1'000'000));
}

TEST_F(StandingTest, AttitudeMayDifferByThreeDegrees) {
  const Eigen::Matrix3d upright = state_.X_WB.linear();
  const double deg = 3.14159265358979 / 180;
  state_.X_WB.linear() = RotationFromRpy({2.9 * deg, 0, 0}) * upright;
  EXPECT_TRUE(After(1'000'000));
  state_.X_WB.linear() = RotationFromRpy({3.2 * deg, 0, 0}) * upright;
  EXPECT_FALSE(After(1'000'000));
  state_.X_WB.linear() = RotationFromRpy({0, 3.2 * deg, 0}) * upright;
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
