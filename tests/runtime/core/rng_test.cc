#include "runtime/base/rng.h"

#include <gtest/gtest.h>

namespace openr_host {
namespace {

TEST(RngTest, DependsOnSeedAndNameOnly) {
  EXPECT_EQ(Rng(1, "psd").Next(), Rng(1, "psd").Next());
  EXPECT_NE(Rng(1, "psd").Next(), Rng(2, "psd").Next());
  EXPECT_NE(Rng(1, "psd").Next(), Rng(1, "mic").Next());
}

TEST(RngTest, DoublesAndBoundedNumbersStayInRange) {
  Rng rng(7, "range");
  double sum = 0;
  for (int i = 0; i < 10000; ++i) {
    const double value = rng.NextDouble();
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    sum += value;
    ASSERT_LT(rng.NextBelow(3), 3u);
  }
  EXPECT_NEAR(sum / 10000, 0.5, 0.02);
}

}  // namespace
}  // namespace openr_host
