// The eyes of examples/BallChaser on made-up pictures of layer C.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "Eyes.h"
#include "tests/virtualrobot/body_harness.h"

namespace openr_host {
namespace {

constexpr int kWidth = 88, kHeight = 72;

struct Pixels {
  std::vector<byte> bytes = std::vector<byte>(kWidth * kHeight);

  void Set(int x, int y, int colour) {
    if (x < 0 || y < 0 || x >= kWidth || y >= kHeight) return;
    bytes[static_cast<size_t>(y * kWidth + x)] |= static_cast<byte>(colour);
  }
  void Fill(int left, int top, int right, int bottom, int colour) {
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) Set(x, y, colour);
  }
  void FillDisc(double x, double y, double radius, int colour) {
    for (int j = 0; j < kHeight; ++j)
      for (int i = 0; i < kWidth; ++i)
        if (std::hypot(i + 0.5 - x, j + 0.5 - y) <= radius) Set(i, j, colour);
  }
};

class BallChaserEyesTest : public testing::Test {
 protected:
  Sight See(const Pixels& pixels, double tilt = 0, double pan = 0) {
    return eyes_->See(pixels.bytes.data(), kWidth, kHeight, tilt, pan);
  }
  std::unique_ptr<Eyes> eyes_ = std::make_unique<Eyes>();
};

// Returns where the camera of the model sees the point `p_B`, in pixels.
Eigen::Vector2d PixelOf(const Eigen::Vector3d& p_B, double tilt, double pan) {
  const RobotModel& model = Ers210();
  std::vector<double> angles(model.joints.size());
  angles[static_cast<size_t>(model.FindJoint("neck_tilt"))] = tilt;
  angles[static_cast<size_t>(model.FindJoint("neck_pan"))] = pan;
  const Eigen::Isometry3d X_BH = LinkPoses(model, angles)[static_cast<size_t>(model.camera.body)];
  const Eigen::Vector3d p_C = X_BH.inverse() * p_B - model.camera.place_m;
  const double left = p_C.y() / p_C.x() / std::tan(model.camera.fov_h_rad / 2);
  const double up = p_C.z() / p_C.x() / std::tan(model.camera.fov_v_rad / 2);
  return {(1 - left) * kWidth / 2, (1 - up) * kHeight / 2};
}

TEST_F(BallChaserEyesTest, SeeNothingInAnEmptyPicture) {
  const Sight sight = See({});
  EXPECT_FALSE(sight.ball.isSeen);
  EXPECT_FALSE(sight.goal[SKY_BLUE_GOAL].isSeen);
  EXPECT_FALSE(sight.goal[YELLOW_GOAL].isSeen);
}

TEST_F(BallChaserEyesTest, PlaceTheBallByTheAnglesOfTheNeck) {
  struct Case {
    double x, y, tilt, pan;
  };
  for (const Case& c : {Case{1000, 0, 0, 0}, Case{600, 150, -0.3, 0.2}, Case{500, -300, -0.3, -0.6},
                        Case{300, 0, -0.7, 0}}) {
    SCOPED_TRACE(fmt::format("ball at {}, {}", c.x, c.y));
    const Eigen::Vector2d pixel = PixelOf({c.x / 1000, c.y / 1000, 0.043 - 0.098}, c.tilt, c.pan);
    Pixels pixels;
    pixels.FillDisc(pixel.x(), pixel.y(), 3, ORANGE);
    const Sight sight = See(pixels, c.tilt, c.pan);
    ASSERT_TRUE(sight.ball.isSeen);
    EXPECT_NEAR(sight.ball.x, c.x, 0.06 * c.x);
    EXPECT_NEAR(sight.ball.y, c.y, 20);
  }
}

TEST_F(BallChaserEyesTest, TakeTheLargestOfSeveralOrangeBlobs) {
  Pixels pixels;
  pixels.FillDisc(20, 60, 2, ORANGE);
  pixels.FillDisc(66, 54, 5, ORANGE);
  const Sight sight = See(pixels);
  ASSERT_TRUE(sight.ball.isSeen);
  EXPECT_LT(sight.ball.y, -150);
}

TEST_F(BallChaserEyesTest, SeeNoBallInTwoPixelsOrAboveTheHorizon) {
  Pixels two;
  two.Fill(40, 50, 41, 50, ORANGE);
  EXPECT_FALSE(See(two).ball.isSeen);
  Pixels above;
  above.FillDisc(44, 20, 4, ORANGE);
  EXPECT_FALSE(See(above).ball.isSeen);
}

TEST_F(BallChaserEyesTest, TakeTheTagOfTheLastRowForNoColour) {
  Pixels pixels;
  pixels.Fill(0, kHeight - 1, 15, kHeight - 1, ORANGE | YELLOW);
  const Sight sight = See(pixels);
  EXPECT_FALSE(sight.ball.isSeen);
  EXPECT_FALSE(sight.goal[YELLOW_GOAL].isSeen);
}

TEST_F(BallChaserEyesTest, FindTheEndsOfAGoal) {
  Pixels pixels;
  pixels.Fill(44, 25, 63, 36, YELLOW);
  const Sight sight = See(pixels);
  EXPECT_FALSE(sight.goal[SKY_BLUE_GOAL].isSeen);
  ASSERT_TRUE(sight.goal[YELLOW_GOAL].isSeen);
  EXPECT_NEAR(sight.goal[YELLOW_GOAL].left, 0, 1e-6);
  EXPECT_NEAR(Degrees(sight.goal[YELLOW_GOAL].right), -14.0, 0.2);
  EXPECT_NEAR(Degrees(See(pixels, 0, 0.5).goal[YELLOW_GOAL].right), -14.0 + 28.65, 0.2);
}

TEST_F(BallChaserEyesTest, TakeABeaconForNoGoal) {
  Pixels narrow;
  narrow.Fill(40, 20, 47, 27, SKY_BLUE);
  EXPECT_FALSE(See(narrow).goal[SKY_BLUE_GOAL].isSeen);
  Pixels near;
  near.Fill(30, 20, 49, 39, SKY_BLUE);
  near.Fill(30, 40, 49, 59, PINK);
  EXPECT_FALSE(See(near).goal[SKY_BLUE_GOAL].isSeen);
  Pixels other_order;
  other_order.Fill(30, 20, 49, 39, SKY_BLUE);
  other_order.Fill(30, 1, 49, 19, PINK);
  EXPECT_FALSE(See(other_order).goal[SKY_BLUE_GOAL].isSeen);
}

TEST(BallChaserBlobTest, APictureThatIsTooLargeHasNoBlobs) {
  const std::vector<byte> pixels(200 * 100, 1);
  const auto finder = std::make_unique<BlobFinder>();
  EXPECT_EQ(finder->FindLargest(pixels.data(), 200, 100, 1).numPixels, 0);
  EXPECT_EQ(finder->FindLargest(pixels.data(), 100, 80, 1).numPixels, 100 * 79);
}

}  // namespace
}  // namespace openr_host
