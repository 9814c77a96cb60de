// Runs all tests of a program; the last line is "N passed, N failed" (", N skipped").
#include <gtest/gtest.h>

#include <cstdio>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  const testing::UnitTest& unit = *testing::UnitTest::GetInstance();
  const int skipped = unit.skipped_test_count();
  std::printf("%d passed, %d failed", unit.successful_test_count(), unit.failed_test_count());
  if (skipped > 0) std::printf(", %d skipped", skipped);
  std::printf("\n");
  return result;
}
