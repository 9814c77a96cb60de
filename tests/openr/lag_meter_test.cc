#include "openr/pair/lag_meter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace openr_host {
namespace {

constexpr int64_t kEndMs = 6000;

// Positions of two joints at `time_ms`, in 0.01 degree: one swings with this period, one rests.
std::vector<int32_t> Swing(int64_t time_ms, double period_ms) {
  const double angle = 2 * M_PI * static_cast<double>(time_ms) / period_ms;
  return {100, static_cast<int32_t>(std::lround(2000 * std::sin(angle)))};
}

// Returns a meter whose follower is `lag_ms` behind.  Samples of both come every 32 ms, but not at
// the same time.
LagMeter Measured(int64_t lag_ms, double period_ms, int32_t offset = 0) {
  LagMeter meter;
  for (int64_t t = 0; t <= kEndMs; t += 32) {
    meter.AddLeader(t, Swing(t, period_ms));
    std::vector<int32_t> behind = Swing(t + 7 - lag_ms, period_ms);
    behind[1] += offset;
    meter.AddFollower(t + 7, behind);
  }
  return meter;
}

TEST(LagMeterTest, FindsTheLagToAFewMilliseconds) {
  for (const int64_t lag_ms : {0, 40, 136, 412, 900}) {
    const auto found = Measured(lag_ms, 2600).LagMs();
    ASSERT_TRUE(found) << lag_ms;
    EXPECT_NEAR(static_cast<double>(*found), static_cast<double>(lag_ms), 8) << lag_ms;
  }
}

TEST(LagMeterTest, AMovementThatRepeatsItselfHasItsSmallestLag) {
  EXPECT_NEAR(static_cast<double>(Measured(120, 640).LagMs().value_or(-1)), 120, 8);
}

TEST(LagMeterTest, AConstantDifferenceIsNoLag) {
  EXPECT_NEAR(static_cast<double>(Measured(80, 2000, 700).LagMs().value_or(-1)), 80, 8);
}

TEST(LagMeterTest, WithoutMovementThereIsNoLag) {
  LagMeter meter;
  EXPECT_FALSE(meter.LagMs());
  for (int64_t t = 0; t <= kEndMs; t += 32) {
    meter.AddLeader(t, {100, static_cast<int32_t>(t % 100)});
    meter.AddFollower(t, {100, 0});
  }
  EXPECT_FALSE(meter.LagMs());
}

TEST(LagMeterTest, ARobotThatDoesNotFollowHasNoLag) {
  LagMeter meter;
  for (int64_t t = 0; t <= kEndMs; t += 32) {
    meter.AddLeader(t, Swing(t, 1000));
    meter.AddFollower(t, {100, 0});
  }
  EXPECT_FALSE(meter.LagMs());
}

TEST(LagMeterTest, AnOddNumberOfJointsIsLeftOut) {
  LagMeter meter = Measured(40, 2600);
  meter.AddLeader(kEndMs + 32, {});
  meter.AddFollower(kEndMs + 32, {1, 2, 3});
  EXPECT_NEAR(static_cast<double>(meter.LagMs().value_or(-1)), 40, 8);
}

}  // namespace
}  // namespace openr_host
