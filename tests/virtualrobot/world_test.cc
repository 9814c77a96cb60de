#include "virtualrobot/world.h"

#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

constexpr const char* kWall = R"({
  "schema": "openr-host world 1", "name": "wall", "friction": 0.4,
  "boxes": [{"name": "wall", "size_m": [0.1, 2, 0.5], "centre_m": [1, 0, 0.25], "yaw_deg": 0}]
})";

std::string ErrorWith(const std::string& before, const std::string& after) {
  std::string text = kWall;
  text.replace(text.find(before), before.size(), after);
  return ErrorOf([&] { ParseWorld(text, "w.json"); });
}

TEST(WorldTest, ReadsFrictionAndBoxes) {
  const World world = ParseWorld(kWall, "w.json");
  EXPECT_EQ(world.name, "wall");
  EXPECT_EQ(world.floor_friction, 0.4);
  ASSERT_EQ(world.boxes.size(), 1u);
  EXPECT_EQ(world.boxes[0].size_m, Vector3d(0.1, 2, 0.5));
}

TEST(WorldTest, FrictionAndBoxesMayBeLeftOut) {
  const World world = ParseWorld(R"({"schema": "openr-host world 1", "name": "flat"})", "w.json");
  EXPECT_EQ(world.floor_friction, World{}.floor_friction);
  EXPECT_TRUE(world.boxes.empty());
}

TEST(WorldTest, FlatBoxIsRefused) {
  EXPECT_EQ(ErrorWith("[0.1, 2, 0.5]", "[0.1, 2, 0]"),
            "w.json: boxes[0].size_m: box 'wall' is 0.1 x 2 x 0 m, edges must be > 0");
}

TEST(WorldTest, NegativeFrictionIsRefused) {
  EXPECT_EQ(ErrorWith("0.4", "-0.4"), "w.json: friction: is -0.4, must be >= 0");
}

TEST(WorldTest, MissingPlaceIsNamed) {
  EXPECT_EQ(ErrorWith(", \"centre_m\": [1, 0, 0.25]", ""),
            "w.json: boxes[0]: 'centre_m' is missing");
}

TEST(WorldTest, UnknownFieldIsRefused) {
  EXPECT_EQ(ErrorWith("yaw_deg", "yaw"),
            "w.json: boxes[0]: 'yaw' is unknown; known here: name, size_m, centre_m, yaw_deg");
}

TEST(WorldTest, TextInsteadOfANumberIsShown) {
  EXPECT_EQ(ErrorWith("0.4", "\"icy\""), "w.json: friction: must be a number, is \"icy\"");
}

// Beyond what a double holds.
TEST(WorldTest, ANumberOutOfRangeIsRefusedWithItsPlace) {
  const std::string error = ErrorWith("0.4", "1e999");
  EXPECT_NE(error.find("w.json"), std::string::npos) << error;
  EXPECT_NE(error.find("1e999"), std::string::npos) << error;
}

TEST(WorldTest, AListIsNoWorld) {
  EXPECT_EQ(ErrorOf([] { ParseWorld("[]", "w.json"); }), "w.json: must be an object, is []");
}

TEST(WorldTest, MissingFileIsNamed) {
  EXPECT_EQ(ErrorOf([] { LoadWorld("no/world.json"); }),
            "no/world.json: No such file or directory");
}

TEST(RayDistanceTest, SeesTheWallItLooksAt) {
  EXPECT_DOUBLE_EQ(RayDistance(ParseWorld(kWall, "w"), {0, 0, 0.2}, {1, 0, 0}, 2), 0.95);
}

TEST(RayDistanceTest, SeesNothingBehindItself) {
  EXPECT_EQ(RayDistance(ParseWorld(kWall, "w"), {0, 0, 0.2}, {-1, 0, 0}, 2), 2);
}

TEST(RayDistanceTest, LooksOverALowWall) {
  EXPECT_EQ(RayDistance(ParseWorld(kWall, "w"), {0, 0, 0.6}, {1, 0, 0}, 2), 2);
}

TEST(RayDistanceTest, SeesTheFloorWhenItLooksDown) {
  EXPECT_DOUBLE_EQ(RayDistance(World{}, {0, 0, 0.3}, {0.8, 0, -0.6}, 2), 0.5);
}

TEST(RayDistanceTest, IsCappedAtTheLargestDistance) {
  EXPECT_EQ(RayDistance(World{}, {0, 0, 0.3}, {0.8, 0, -0.6}, 0.4), 0.4);
}

TEST(RayDistanceTest, IsZeroInsideABox) {
  EXPECT_EQ(RayDistance(ParseWorld(kWall, "w"), {1, 0, 0.2}, {1, 0, 0}, 2), 0);
}

// Turned by 45 degrees a cube of edge 0.2 shows its edge at half its diagonal.
TEST(RayDistanceTest, KnowsThatABoxIsTurned) {
  World world;
  world.boxes.push_back(
      {.name = "cube", .size_m = {0.2, 0.2, 0.2}, .centre_m = {1, 0, 0.1}, .yaw_rad = Radians(45)});
  EXPECT_NEAR(RayDistance(world, {0, 0, 0.1}, {1, 0, 0}, 2), 1 - 0.1 * std::sqrt(2), 1e-12);
}

}  // namespace
}  // namespace openr_host
