#include "Trajectory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <vector>

#include "Angle.h"

namespace openr_host {
namespace {

constexpr int32_t kDeg = 17453;          // urad, near enough for sizes of movements
constexpr int32_t kDefaultAccel = 4883;  // 0.01 degree/s^2

// A speed of 0.01 degree/s in urad per 8 ms frame, rounded up.
double UradPerFrame(int32_t cdeg_s) { return cdeg_s * 174.532925199 * 0.008 + 1; }
double UradPerFrame2(int32_t cdeg_s2) { return cdeg_s2 * 174.532925199 * 0.008 * 0.008 + 2; }

Trajectory At(int32_t urad, int32_t speed_cdeg, int32_t accel_cdeg) {
  Trajectory trajectory;
  trajectory.Reset(urad);
  trajectory.SetSpeed(speed_cdeg);
  trajectory.SetAcceleration(accel_cdeg);
  return trajectory;
}

// Positions of all frames until rest, the start first.
std::vector<int32_t> WayToRest(Trajectory* trajectory, int frames_max = 20000) {
  std::vector<int32_t> positions{trajectory->Position()};
  while (trajectory->IsMoving() && frames_max-- > 0) positions.push_back(trajectory->Step());
  return positions;
}

// `last_step` is the step of the frame before p[0].
void ExpectWithinLimits(const std::vector<int32_t>& p, int32_t speed_cdeg, int32_t accel_cdeg,
                        int32_t last_step = 0) {
  for (size_t i = 1; i < p.size(); ++i) {
    const int32_t step = p[i] - p[i - 1];
    ASSERT_LE(std::abs(step), UradPerFrame(speed_cdeg)) << "frame " << i;
    ASSERT_LE(std::abs(step - last_step), UradPerFrame2(accel_cdeg)) << "frame " << i;
    last_step = step;
  }
}

TEST(TrajectoryTest, ARestingJointStaysWhereItIs) {
  Trajectory trajectory = At(1234, 16125, kDefaultAccel);
  EXPECT_FALSE(trajectory.IsMoving());
  EXPECT_EQ(trajectory.Step(), 1234);
}

TEST(TrajectoryTest, TrackGoesStraightToTheGoalWhateverTheLimitsAre) {
  Trajectory trajectory = At(0, 100, 312);
  trajectory.Track(10 * kDeg, 5);
  EXPECT_EQ(WayToRest(&trajectory),
            (std::vector<int32_t>{0, 2 * kDeg, 4 * kDeg, 6 * kDeg, 8 * kDeg, 10 * kDeg}));
  EXPECT_FALSE(trajectory.IsMoving());
}

TEST(TrajectoryTest, AfterTrackTheLimitsAreInForceAgain) {
  Trajectory trajectory = At(0, 10000, kDefaultAccel);
  trajectory.Track(kDeg, 2);
  WayToRest(&trajectory);
  trajectory.SetGoal(30 * kDeg);
  ExpectWithinLimits(WayToRest(&trajectory), 10000, kDefaultAccel);
  EXPECT_EQ(trajectory.Position(), 30 * kDeg);
}

TEST(TrajectoryTest, AGoalDuringTrackGoesOnWithThePresentSpeedAndEndsAtTheGoal) {
  Trajectory trajectory = At(0, 10000, kDefaultAccel);
  trajectory.Track(20 * kDeg, 20);
  for (int i = 0; i < 5; ++i) trajectory.Step();
  EXPECT_EQ(trajectory.Position(), 5 * kDeg);
  trajectory.SetGoal(6 * kDeg);
  const std::vector<int32_t> way = WayToRest(&trajectory);
  ExpectWithinLimits(way, 12500, kDefaultAccel, kDeg);
  EXPECT_EQ(way.back(), 6 * kDeg);
}

TEST(TrajectoryTest, HaltDuringTrackStopsWithinTheLimitOfAcceleration) {
  Trajectory trajectory = At(0, 10000, kDefaultAccel);
  trajectory.Track(20 * kDeg, 40);
  for (int i = 0; i < 10; ++i) trajectory.Step();
  trajectory.Halt();
  const std::vector<int32_t> way = WayToRest(&trajectory);
  ExpectWithinLimits(way, 10000, kDefaultAccel, kDeg / 2);
  EXPECT_GT(way.back(), 5 * kDeg);
}

TEST(TrajectoryTest, EndsExactlyAtTheGoalForEveryGoal) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const int32_t start = static_cast<int32_t>(random() % 4000000) - 2000000;
    const int32_t goal = static_cast<int32_t>(random() % 4000000) - 2000000;
    Trajectory trajectory = At(start, 16125, 312 + random() % 30000);
    trajectory.SetGoal(goal);
    EXPECT_EQ(WayToRest(&trajectory).back(), goal);
    EXPECT_FALSE(trajectory.IsMoving());
  }
}

TEST(TrajectoryTest, KeepsSpeedAndAccelerationLimits) {
  for (const int32_t accel : {313, kDefaultAccel, 31250}) {
    for (const int32_t speed : {250, 6000, 25625}) {
      SCOPED_TRACE(testing::Message() << "speed " << speed << " accel " << accel);
      Trajectory trajectory = At(0, speed, accel);
      trajectory.SetGoal(90 * kDeg);
      const std::vector<int32_t> positions = WayToRest(&trajectory);
      ExpectWithinLimits(positions, speed, accel);
      EXPECT_EQ(positions.back(), 90 * kDeg);
    }
  }
}

TEST(TrajectoryTest, NeverPassesTheGoalFromRest) {
  Trajectory trajectory = At(0, 17250, 31250);
  trajectory.SetGoal(30 * kDeg);
  for (const int32_t position : WayToRest(&trajectory)) EXPECT_LE(position, 30 * kDeg);
}

// 30 degrees at 48.83 degree/s^2 without reaching the speed limit: 2 sqrt(30 / 48.83) = 1.568 s.
TEST(TrajectoryTest, TakesTheTimeOfATriangleOfSpeed) {
  Trajectory trajectory = At(0, 17250, kDefaultAccel);
  trajectory.SetGoal(UradFromCdeg(3000));
  EXPECT_NEAR(static_cast<double>(WayToRest(&trajectory).size()) * 0.008, 1.568, 0.02);
}

// 90 degrees at 60 degree/s and 48.83 degree/s^2: 90 / 60 + 60 / 48.83 = 2.729 s.
TEST(TrajectoryTest, TakesTheTimeOfATrapezoidOfSpeed) {
  Trajectory trajectory = At(0, 6000, kDefaultAccel);
  trajectory.SetGoal(UradFromCdeg(9000));
  EXPECT_NEAR(static_cast<double>(WayToRest(&trajectory).size()) * 0.008, 2.729, 0.02);
}

// Hohl 2004, 3.1.2: smallest speed and largest acceleration still give one frame of acceleration.
TEST(TrajectoryTest, SmallestSpeedIsReachedInOneFrameOfLargestAcceleration) {
  Trajectory trajectory = At(0, 250, 31250);
  trajectory.SetGoal(kDeg);
  const int32_t first = trajectory.Step();
  EXPECT_EQ(first, 349);  // 2.5 degree/s for 8 ms
  EXPECT_NEAR(trajectory.Step() - first, first, 1);
}

TEST(TrajectoryTest, ANewGoalOnTheWayCausesNoJump) {
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    Trajectory trajectory = At(0, 16125, kDefaultAccel);
    std::vector<int32_t> positions{0};
    for (int i = 0; i < 600; ++i) {
      if (i % 40 == 0) trajectory.SetGoal(static_cast<int32_t>(random() % 3000000) - 1500000);
      positions.push_back(trajectory.Step());
    }
    ExpectWithinLimits(positions, 16125, kDefaultAccel);
    WayToRest(&trajectory);
    EXPECT_EQ(trajectory.Position(), trajectory.Goal());
  }
}

TEST(TrajectoryTest, AGoalTooNearToStopAtIsPassedAndReachedFromTheOtherSide) {
  Trajectory trajectory = At(0, 16125, kDefaultAccel);
  trajectory.SetGoal(90 * kDeg);
  for (int i = 0; i < 150; ++i) trajectory.Step();
  const int32_t here = trajectory.Position();
  trajectory.SetGoal(here);
  const std::vector<int32_t> positions = WayToRest(&trajectory);
  EXPECT_GT(*std::max_element(positions.begin(), positions.end()), here + kDeg);
  EXPECT_EQ(positions.back(), here);
}

TEST(TrajectoryTest, ALowerAccelerationOnTheWayDoesNotCarryTheJointPastItsGoal) {
  Trajectory trajectory = At(0, 16125, 31250);
  trajectory.SetGoal(110 * kDeg);
  for (int i = 0; i < 60; ++i) trajectory.Step();
  trajectory.SetAcceleration(313);
  for (const int32_t position : WayToRest(&trajectory)) EXPECT_LE(position, 110 * kDeg);
  EXPECT_EQ(trajectory.Position(), 110 * kDeg);
}

TEST(TrajectoryTest, ALowerAccelerationCountsFromTheNextRest) {
  Trajectory trajectory = At(0, 16125, 31250);
  trajectory.SetGoal(10 * kDeg);
  trajectory.Step();
  trajectory.SetAcceleration(kDefaultAccel);
  WayToRest(&trajectory);
  trajectory.SetGoal(0);
  ExpectWithinLimits(WayToRest(&trajectory), 16125, kDefaultAccel);
}

TEST(TrajectoryTest, ALowerSpeedLimitSlowsTheJointWithinItsAcceleration) {
  Trajectory trajectory = At(0, 16125, kDefaultAccel);
  trajectory.SetGoal(110 * kDeg);
  for (int i = 0; i < 150; ++i) trajectory.Step();
  trajectory.SetSpeed(1000);
  std::vector<int32_t> positions;
  for (int i = 0; i < 200; ++i) positions.push_back(trajectory.Step());
  EXPECT_LE(positions[199] - positions[198], UradPerFrame(1000));
  for (size_t i = 2; i < positions.size(); ++i) {
    EXPECT_LE(std::abs(positions[i] - 2 * positions[i - 1] + positions[i - 2]),
              UradPerFrame2(kDefaultAccel));
  }
}

TEST(TrajectoryTest, HaltStopsAsSoonAsTheAccelerationAllows) {
  Trajectory trajectory = At(0, 16125, 31250);
  trajectory.SetGoal(110 * kDeg);
  for (int i = 0; i < 59; ++i) trajectory.Step();
  const int32_t before = trajectory.Position();
  const int32_t here = trajectory.Step();
  trajectory.Halt();
  const std::vector<int32_t> positions = WayToRest(&trajectory);
  ExpectWithinLimits(positions, 16125, 31250, here - before);
  EXPECT_LT(positions.size(), 70u);
  EXPECT_LT(positions.back() - here, 45 * kDeg);
}

// These frames must be the same with every compiler and word size.
TEST(TrajectoryTest, FramesAreTheSameEverywhere) {
  Trajectory trajectory = At(-174533, 12062, kDefaultAccel);
  trajectory.SetGoal(750491);
  uint32_t sum = 0;
  int frames = 0;
  while (trajectory.IsMoving()) {
    sum = sum * 31 + static_cast<uint32_t>(trajectory.Step());
    ++frames;
  }
  EXPECT_EQ(frames, 260);
  EXPECT_EQ(sum, 3290761401u);
}

TEST(AngleTest, DegreesAndMicroRadiansConvertBothWays) {
  EXPECT_EQ(UradFromCdeg(9000), 1570796);
  EXPECT_EQ(UradFromCdeg(-11700), -2042035);
  EXPECT_EQ(CdegFromUrad(523599), 3000);
  for (int32_t cdeg = -36000; cdeg <= 36000; cdeg += 7)
    ASSERT_EQ(CdegFromUrad(UradFromCdeg(cdeg)), cdeg);
}

TEST(AngleTest, AbsurdAnglesSaturateInsteadOfOverflowing) {
  EXPECT_EQ(UradFromCdeg(2147483647), UradFromCdeg(3600000));
  EXPECT_EQ(UradFromCdeg(-2147483647 - 1), UradFromCdeg(-3600000));
}

}  // namespace
}  // namespace openr_host
