// The input `target`, by which programs give servos their set points.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "testing/bench.h"
#include "virtualrobot/virtual_robot.h"

namespace openr::testing {
namespace {

BenchOptions StandingDog() { return {.stick = DefaultStick(), .body = "ideal"}; }

class TargetTest : public ::testing::Test {
 protected:
  TargetTest() {
    bench.Boot();
    bench.RunFor(15s);
  }
  double TargetUrad(const char* joint) {
    const auto index = static_cast<size_t>(bench.model().FindJoint(joint));
    return static_cast<double>(bench.dog().devices().joints[index].target_urad);
  }
  std::string Refusal(const char* input) { return bench.system().inputs().Check(0, input); }

  Bench bench{StandingDog()};
};

TEST_F(TargetTest, AJointGoesToItsSetPointInOneFrame) {
  EXPECT_TRUE(bench.Do("target neck_pan 10"));
  bench.Frame();
  EXPECT_NEAR(TargetUrad("neck_pan"), 174'533, 1);
  EXPECT_NEAR(bench.JointDeg("neck_pan"), 10, 0.01);
}

TEST_F(TargetTest, ASetPointMovesEvenlyInItsTime) {
  const double begin = TargetUrad("neck_pan");
  EXPECT_TRUE(bench.Do("target neck_pan 20 neck_tilt -4 in 80ms"));
  bench.Frame(4);  // the fifth of ten set points is in force
  EXPECT_NEAR(TargetUrad("neck_pan"), (begin + 349'066) / 2, 2);
  bench.Frame(20);
  EXPECT_NEAR(bench.JointDeg("neck_pan"), 20, 0.01);
  EXPECT_NEAR(bench.JointDeg("neck_tilt"), -4, 0.01);
}

// The objects' own set points are in force again when the joint is released.
TEST_F(TargetTest, ItHoldsAgainstTheObjectsUntilItIsReleased) {
  EXPECT_TRUE(bench.Do("target tail_pan 15"));
  bench.RunFor(3s);  // the controller of the stick wags the tail
  EXPECT_NEAR(bench.JointDeg("tail_pan"), 15, 0.01);
  EXPECT_TRUE(bench.Release("tail_pan"));
  bench.RunFor(3s);
  EXPECT_GT(std::abs(bench.JointDeg("tail_pan") - 15), 0.1);
}

TEST_F(TargetTest, OffReleasesAllJoints) {
  EXPECT_TRUE(bench.Do("target tail_pan 15"));
  bench.Frame();
  EXPECT_TRUE(bench.Do("target off"));
  bench.RunFor(3s);
  EXPECT_GT(std::abs(bench.JointDeg("tail_pan") - 15), 0.1);
}

TEST_F(TargetTest, TheEndOfATurnDoesNotRelease) {
  EXPECT_TRUE(bench.Do("target tail_pan 15"));
  EXPECT_TRUE(bench.Do("turn tail_pan 5 for 80ms"));
  bench.RunFor(2s);
  EXPECT_NEAR(bench.JointDeg("tail_pan"), 15, 0.01);
}

TEST_F(TargetTest, AWrongLineIsRefusedAndSaysWhy) {
  using ::testing::HasSubstr;
  EXPECT_THAT(Refusal("target"), HasSubstr("needs joints, each with an angle"));
  EXPECT_THAT(Refusal("target neck_pan"), HasSubstr("needs joints, each with an angle"));
  EXPECT_THAT(Refusal("target neck_pam 3"), HasSubstr("did you mean 'neck_pan'"));
  EXPECT_THAT(Refusal("target neck_pan far"), HasSubstr("'far' is no number"));
  EXPECT_THAT(Refusal("target neck_pan nan"), HasSubstr("'nan' is no number"));
  EXPECT_THAT(Refusal("target neck_pan 200"), HasSubstr("beyond the stops of neck_pan"));
  EXPECT_THAT(Refusal("target neck_pan 1 in"), HasSubstr("target"));
  EXPECT_THAT(Refusal("target neck_pan 1 in soon"), HasSubstr("soon"));
  const uint64_t before = bench.system().state_hash();
  EXPECT_EQ(Refusal("target neck_pan 1 neck_tilt 2 in 1s"), "");
  EXPECT_EQ(bench.system().state_hash(), before);
}

TEST_F(TargetTest, AShutdownEndsIt) {
  EXPECT_TRUE(bench.Do("target neck_pan 15"));
  bench.Frame();
  EXPECT_TRUE(bench.Do("shutdown"));
  bench.RunFor(5s);
  EXPECT_TRUE(bench.system().powered_off());
}

}  // namespace
}  // namespace openr::testing
