// A ball program of the usual kind on the test pattern: colour table, layer C, colour frequency.
#include <openr/testing.h>

#include <cstdio>
#include <sstream>

namespace openr_host {
namespace {

using openr::testing::Bench;

// Where the pattern's ball is in layer C: it goes along the middle in 50 images, and back.
struct BallPlace {
  explicit BallPlace(int image) {
    constexpr int kRadius = 288 / 8, kWay = 352 - 2 * kRadius;
    const int step = image % 100;
    x = (kRadius + kWay * (step < 50 ? step : 100 - step) / 50) / 4;
    y = 288 / 2 / 4;
  }
  int x, y;
};

TEST(BallFinderGraphTest, ColourDetectionAndColourFrequencyFindTheBallOfTheTestPattern) {
  Bench bench({.body = "ideal", .images = "pattern"});
  bench.AddImage(OPENR_IMAGES "/BALLFIND.BIN");
  bench.Wire("OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S",
             "BallFinder.Image.OFbkImageVectorData.O");
  bench.Boot();
  bench.RunFor(std::chrono::seconds(5));

  std::istringstream lines(bench.console());
  int images = 0, last_field = 0;
  for (std::string line; std::getline(lines, line);) {
    int field = 0, count = 0, x = 0, y = 0, frequency = 0;
    if (std::sscanf(line.c_str(), "field %d: %d pixels of the ball at %d, %d; frequency %d", &field,
                    &count, &x, &y, &frequency) != 5) {
      continue;
    }
    if (images++ > 0) {
      EXPECT_EQ(field, last_field + 1);
    }
    last_field = field;
    EXPECT_NEAR(count, 245, 15) << line;  // a disk with a radius of 9 pixels
    EXPECT_EQ(frequency, count / 16) << line;
    EXPECT_NEAR(x, BallPlace(field).x, 1) << line;
    EXPECT_NEAR(y, BallPlace(field).y, 1) << line;
  }
  EXPECT_GT(images, 120);  // 25 a second
  EXPECT_EQ(bench.Findings(), "");
}

}  // namespace
}  // namespace openr_host
