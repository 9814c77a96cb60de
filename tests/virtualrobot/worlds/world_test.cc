#include "virtualrobot/worlds/world.h"

#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

// Returns the distance that a ray goes in `world`.
double DistanceIn(const World& world, const Vector3d& p_W, const Vector3d& direction_W,
                  double max_m) {
  return CastRay(world, world.things, p_W, direction_W, max_m).distance_m;
}

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
  ASSERT_EQ(world.things.size(), 1u);
  EXPECT_EQ(world.things[0].size_m, Vector3d(0.1, 2, 0.5));
}

TEST(WorldTest, FrictionAndBoxesMayBeLeftOut) {
  const World world = ParseWorld(R"({"schema": "openr-host world 1", "name": "flat"})", "w.json");
  EXPECT_EQ(world.floor_friction, World{}.floor_friction);
  EXPECT_TRUE(world.things.empty());
}

TEST(WorldTest, FlatBoxIsRefused) {
  EXPECT_EQ(ErrorWith("[0.1, 2, 0.5]", "[0.1, 2, 0]"),
            "w.json: boxes[0].size_m: box 'wall' is 0.1 x 2 x 0 m, edges must be > 0");
}

TEST(WorldTest, ABoxThatIsTooFarAwayIsRefused) {
  EXPECT_EQ(ErrorWith("[1, 0, 0.25]", "[1001, 0, 0.25]"),
            "w.json: boxes[0]: 'wall' is larger, or further away, than 1000 m");
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
  EXPECT_TRUE(error.starts_with("w.json:")) << error;
  EXPECT_TRUE(error.ends_with(": the number 1e999 is too large")) << error;
}

TEST(WorldTest, AListIsNoWorld) {
  EXPECT_EQ(ErrorOf([] { ParseWorld("[]", "w.json"); }), "w.json: must be an object with 'schema'");
}

TEST(WorldTest, MissingFileIsNamed) {
  EXPECT_EQ(ErrorOf([] { LoadWorld("no/world.json"); }),
            "no/world.json: No such file or directory");
}

TEST(CastRayTest, SeesTheWallItLooksAt) {
  EXPECT_DOUBLE_EQ(DistanceIn(ParseWorld(kWall, "w"), {0, 0, 0.2}, {1, 0, 0}, 2), 0.95);
}

TEST(CastRayTest, SeesNothingBehindItself) {
  EXPECT_EQ(DistanceIn(ParseWorld(kWall, "w"), {0, 0, 0.2}, {-1, 0, 0}, 2), 2);
}

TEST(CastRayTest, LooksOverALowWall) {
  EXPECT_EQ(DistanceIn(ParseWorld(kWall, "w"), {0, 0, 0.6}, {1, 0, 0}, 2), 2);
}

TEST(CastRayTest, SeesTheFloorWhenItLooksDown) {
  EXPECT_DOUBLE_EQ(DistanceIn(World{}, {0, 0, 0.3}, {0.8, 0, -0.6}, 2), 0.5);
}

TEST(CastRayTest, IsCappedAtTheLargestDistance) {
  EXPECT_EQ(DistanceIn(World{}, {0, 0, 0.3}, {0.8, 0, -0.6}, 0.4), 0.4);
}

TEST(CastRayTest, IsZeroInsideABox) {
  EXPECT_EQ(DistanceIn(ParseWorld(kWall, "w"), {1, 0, 0.2}, {1, 0, 0}, 2), 0);
}

// Turned by 45 degrees a cube of edge 0.2 shows its edge at half its diagonal.
TEST(CastRayTest, KnowsThatABoxIsTurned) {
  World world;
  world.things.push_back({.name = "cube",
                          .size_m = {0.2, 0.2, 0.2},
                          .centre_m = {1, 0, 0.1},
                          .R_WT = RotationFromRpy({0, 0, Radians(45)})});
  EXPECT_NEAR(DistanceIn(world, {0, 0, 0.1}, {1, 0, 0}, 2), 1 - 0.1 * std::sqrt(2), 1e-12);
}

// A world of version 2 with the one thing `row`.
World With(const std::string& row) {
  return ParseWorld(R"({"schema": "openr-host world 2", "name": "w", "things": [)" + row + "]}",
                    "w.json");
}

std::string ErrorOfThing(const std::string& row) {
  return ErrorOf([&] { With(row); });
}

TEST(WorldThingTest, EveryShapeIsRead) {
  const WorldThing ball =
      With(R"({"shape":"sphere","name":"b","radius_m":0.1,"centre_m":[1,2,3],"colour":[1,0.5,0]})")
          .things.at(0);
  EXPECT_EQ(ball.shape, ThingShape::kSphere);
  EXPECT_EQ(ball.size_m, Vector3d(0.2, 0.2, 0.2));
  EXPECT_EQ(ball.colour, Vector3d(1, 0.5, 0));
  const WorldThing pole = With(R"({"shape":"cylinder","name":"p","radius_m":0.05,"height_m":0.4,
                                   "centre_m":[1,0,0.2]})")
                              .things.at(0);
  EXPECT_EQ(pole.size_m, Vector3d(0.1, 0.1, 0.4));
  const WorldThing box = With(R"({"shape":"box","name":"q","size_m":[1,2,3],"centre_m":[0,0,1],
                                  "rpy_deg":[90,0,0]})")
                             .things.at(0);
  EXPECT_TRUE((box.R_WT * Vector3d::UnitY()).isApprox(Vector3d::UnitZ(), 1e-12));
}

TEST(WorldThingTest, AnglesAreAtMostAWholeTurn) {
  const auto with_roll = [](const char* roll) {
    return std::string(R"({"shape":"box","name":"q","size_m":[1,1,1],"centre_m":[0,0,1],)") +
           "\"rpy_deg\":[" + roll + ",0,0]}";
  };
  EXPECT_NO_THROW(With(with_roll("360")));
  EXPECT_EQ(ErrorOfThing(with_roll("361")),
            "w.json: things[0].rpy_deg: is [361, 0, 0], angles must be -360 to 360");
}

// A ramp of 0.3 m that rises 0.4 m: its upper face begins at the start and ends 0.3 m ahead.
TEST(WorldThingTest, ARampRisesFromItsStart) {
  const WorldThing ramp = With(R"({"shape":"ramp","name":"r","size_m":[0.3,0.5,0.4],
                                   "start_m":[1,0,0],"yaw_deg":90})")
                              .things.at(0);
  const Vector3d half = ramp.size_m / 2;
  const Vector3d begin = ramp.centre_m + ramp.R_WT * Vector3d(-half.x(), 0, half.z());
  const Vector3d end = ramp.centre_m + ramp.R_WT * Vector3d(half.x(), 0, half.z());
  EXPECT_TRUE(begin.isApprox(Vector3d(1, 0, 0), 1e-12)) << begin.transpose();
  EXPECT_TRUE(end.isApprox(Vector3d(1, 0.3, 0.4), 1e-12)) << end.transpose();
}

TEST(WorldThingTest, StairsAreBoxesThatRise) {
  const World world = With(R"({"shape":"stairs","name":"s","size_m":[0.6,0.5,0.3],"steps":3,
                               "start_m":[1,0,0]})");
  ASSERT_EQ(world.things.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const WorldThing& step = world.things[i];
    EXPECT_EQ(step.name, fmt::format("s {}", i + 1));
    EXPECT_NEAR(step.centre_m.x() - step.size_m.x() / 2, 1 + 0.2 * i, 1e-12);
    EXPECT_NEAR(step.centre_m.x() + step.size_m.x() / 2, 1.2 + 0.2 * i, 1e-12);
    EXPECT_NEAR(step.centre_m.z() - step.size_m.z() / 2, 0, 1e-12);
    EXPECT_NEAR(step.centre_m.z() + step.size_m.z() / 2, 0.1 * (i + 1), 1e-12);
  }
}

TEST(WorldThingTest, MistakesAreNamedWithTheirPlace) {
  EXPECT_EQ(ErrorOfThing(R"({"shape":"cone","name":"c"})"),
            "w.json: things[0].shape: is 'cone'; known are box, sphere, cylinder, ramp, stairs, "
            "heightfield");
  EXPECT_EQ(ErrorOfThing(R"({"shape":"sphere","name":"b","radius_m":0,"centre_m":[0,0,0]})"),
            "w.json: things[0].radius_m: is 0, must be > 0");
  EXPECT_EQ(ErrorOfThing(R"({"shape":"sphere","name":"b","radius_m":1,"centre_m":[0,0,0],
                             "colour":[0,2,0]})"),
            "w.json: things[0].colour: is [0, 2, 0]; red, green and blue must be 0 to 1");
  EXPECT_EQ(ErrorOfThing(R"({"shape":"ramp","name":"r","size_m":[1,1,0],"start_m":[0,0,0]})"),
            "w.json: things[0].size_m: ramp 'r' is 1 x 1 x 0 m, edges must be > 0");
  EXPECT_EQ(ErrorOfThing(R"({"shape":"box","name":"q","size_m":[1,1,1],"centre_m":[0,0,0],
                             "yaw_deg":1,"rpy_deg":[0,0,0]})"),
            "w.json: things[0].yaw_deg: stands beside 'rpy_deg'; leave one out");
  EXPECT_EQ(ErrorOfThing(R"({"shape":"box","name":"q","size_m":[1,1,1],"centre_m":[0,0,0],
                             "yaw_deg":1000})"),
            "w.json: things[0].yaw_deg: is 1000, must be -360 to 360");
  EXPECT_EQ(ErrorOfThing(R"({"shape":"cylinder","name":"c","radius_m":1,"height_m":1e200,
                             "centre_m":[0,0,0]})"),
            "w.json: things[0]: 'c' is larger, or further away, than 1000 m");
  EXPECT_EQ(ErrorOfThing(R"({"shape":"heightfield","name":"h","size_m":[1,1],"centre_m":[0,0,0],
                             "heights_m":[]})"),
            "w.json: things[0].heights_m: has 0 rows of 0 numbers, must have 2 to 64 of each");
}

TEST(CastRayTest, SeesSpheresAndCylinders) {
  const World ball = With(R"({"shape":"sphere","name":"b","radius_m":0.1,"centre_m":[1,0,0.2]})");
  EXPECT_DOUBLE_EQ(DistanceIn(ball, {0, 0, 0.2}, {1, 0, 0}, 2), 0.9);
  EXPECT_NEAR(DistanceIn(ball, {0, 0.06, 0.2}, {1, 0, 0}, 2), 1 - 0.08, 1e-12);
  EXPECT_EQ(DistanceIn(ball, {0, 0.11, 0.2}, {1, 0, 0}, 2), 2);
  EXPECT_EQ(DistanceIn(ball, {1, 0, 0.2}, {1, 0, 0}, 2), 0);  // inside
  EXPECT_EQ(DistanceIn(ball, {2, 0, 0.2}, {1, 0, 0}, 2), 2);  // behind
  const World pole = With(R"({"shape":"cylinder","name":"p","radius_m":0.05,"height_m":0.4,
                              "centre_m":[1,0,0.2]})");
  EXPECT_NEAR(DistanceIn(pole, {0, 0.03, 0.2}, {1, 0, 0}, 2), 1 - 0.04, 1e-12);
  EXPECT_EQ(DistanceIn(pole, {0, 0, 0.5}, {1, 0, 0}, 2), 2);
  EXPECT_DOUBLE_EQ(DistanceIn(pole, {1, 0, 0.7}, {0, 0, -1}, 2), 0.7 - 0.4);
}

TEST(WorldThingTest, TheShippedWorldsAreRead) {
  EXPECT_EQ(LoadWorld(OPENR_WORLD_DIR "/corridor.json").things.size(), 4u);
  EXPECT_EQ(LoadWorld(OPENR_WORLD_DIR "/ramp-and-stairs.json").things.size(), 7u);
}

}  // namespace
}  // namespace openr_host
