// Joints whose commander has crashed: they hold, then go to the sleeping posture, unless another
// object commands them.
#include "virtualrobot/devices/safe_posture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/virtualrobot/body_harness.h"

namespace openr_host {
namespace {

constexpr ObjectId kGone = 7, kOther = 8;
constexpr int64_t kSince = 1000;

class SafePostureTest : public ::testing::Test {
 protected:
  SafePostureTest() {
    devices_.set_commander(kGone);
    devices_.SetTarget(0, 500'000);
    devices_.SetTarget(1, -300'000);
    devices_.set_commander(kOther);
    devices_.SetTarget(2, 100'000);
  }
  slongword RestOf(int joint) const {
    const double rad = model_.PostureAngles("sleep")[static_cast<size_t>(joint)];
    return static_cast<slongword>(std::floor(rad * 1e6 + 0.5));
  }
  slongword TargetAfter(int64_t frames, int joint) {
    posture_.Apply(kSince + frames, &devices_);
    return devices_.joints[static_cast<size_t>(joint)].target_urad;
  }

  const RobotModel& model_ = Ers210();
  Devices devices_{model_};
  SafePosture posture_{model_};
};

TEST_F(SafePostureTest, NothingMovesWhileCommandersAreThere) {
  EXPECT_EQ(TargetAfter(10'000, 0), 500'000);
}

TEST_F(SafePostureTest, JointsHoldThenGoToRestAndStayThere) {
  posture_.OnCommanderLost(kGone, kSince);
  EXPECT_EQ(TargetAfter(SafePosture::kHoldFrames, 0), 500'000);
  const slongword half = TargetAfter(SafePosture::kHoldFrames + SafePosture::kMoveFrames / 2, 0);
  EXPECT_NEAR(half, (500'000 + RestOf(0)) / 2, 2);
  EXPECT_EQ(TargetAfter(SafePosture::kHoldFrames + SafePosture::kMoveFrames, 0), RestOf(0));
  EXPECT_EQ(TargetAfter(100'000, 1), RestOf(1));
}

TEST_F(SafePostureTest, JointsOfOthersAreLeftAlone) {
  posture_.OnCommanderLost(kGone, kSince);
  EXPECT_EQ(TargetAfter(100'000, 2), 100'000);
}

TEST_F(SafePostureTest, AJointThatSomebodyElseTakesIsLeftToHim) {
  posture_.OnCommanderLost(kGone, kSince);
  TargetAfter(SafePosture::kHoldFrames + 10, 0);
  devices_.set_commander(kOther);
  devices_.SetTarget(0, 123'456);
  EXPECT_EQ(TargetAfter(100'000, 0), 123'456);
}

}  // namespace
}  // namespace openr_host
