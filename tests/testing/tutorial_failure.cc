// The failure that docs/testing.md shows is the one there is.
#include <gtest/gtest-spi.h>
#include <openr/testing.h>

#include <fstream>
#include <sstream>

namespace openr::testing {
namespace {

TEST(TutorialTest, TheFailureOfThePageIsTheRealOne) {
  std::ifstream file(TUTORIAL "/failure.txt");
  std::ostringstream page;
  page << file.rdbuf();
  ASSERT_GT(page.str().size(), 20u);

  Bench bench;
  bench.AddImage(METER_BIN);
  ProbeSubject& samples = bench.Feed("Meter.Sample.int.O");
  bench.Watch("Meter.Mean.int.S");
  bench.Boot();
  bench.RunFor(1ms);
  bench.Drop(Ready("Meter.Sample"), 4);  // as if it had forgotten
  for (int i = 0; i < 4; ++i) samples.Send(i);
  EXPECT_NONFATAL_FAILURE(bench.StepTo(Notify("Meter.Mean"), 1s), page.str());
  EXPECT_THAT(bench.Story(), ::testing::HasSubstr("Test1 waits for ready"));
}

}  // namespace
}  // namespace openr::testing
