#include "virtualrobot/base/det_math.h"

#include <gtest/gtest.h>

#include <cmath>

namespace openr_host {
namespace {

// Long double libm is right to 1e-19, enough to judge a double.
constexpr long double kTolerance = 5e-16L;

TEST(DetMathTest, SineAndCosineAgreeWithTheLibraryOverManyTurns) {
  for (int i = -200'000; i <= 200'000; ++i) {
    const double x = i * 0.00493;
    ASSERT_NEAR(DetSin(x), sinl(x), kTolerance) << x;
    ASSERT_NEAR(DetCos(x), cosl(x), kTolerance) << x;
  }
}

TEST(DetMathTest, SineOfZeroIsExactlyZeroAndCosineExactlyOne) {
  EXPECT_EQ(DetSin(0), 0);
  EXPECT_EQ(DetCos(0), 1);
}

TEST(DetMathTest, SineKeepsSmallAnglesToTheLastBit) {
  for (const double x : {1e-300, 1e-20, 1e-9}) EXPECT_EQ(DetSin(x), x);
}

TEST(DetMathTest, ArcTangentAgreesWithTheLibraryInAllQuadrants) {
  for (int i = -300; i <= 300; ++i) {
    for (int k = -300; k <= 300; ++k) {
      const double y = i * 0.01, x = k * 0.013;
      if (y == 0 && x == 0) continue;
      ASSERT_NEAR(DetAtan2(y, x), atan2l(y, x), kTolerance) << y << ", " << x;
    }
  }
}

TEST(DetMathTest, ArcTangentOfTheOriginIsZero) { EXPECT_EQ(DetAtan2(0, 0), 0); }

TEST(DetMathTest, ArcTangentStraightBackIsPlusPiAlsoForNegativeZero) {
  EXPECT_EQ(DetAtan2(0, -1), kPi);
  EXPECT_EQ(DetAtan2(-0.0, -1), kPi);
}

TEST(DetMathTest, DegreesAndRadiansAreInverse) {
  EXPECT_DOUBLE_EQ(Radians(180), kPi);
  EXPECT_DOUBLE_EQ(Degrees(Radians(-77.25)), -77.25);
}

}  // namespace
}  // namespace openr_host
