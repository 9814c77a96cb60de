// Fields of world files about matter and looks: mass, paint, reflectance, colours, light.
#include <gtest/gtest.h>

#include "runtime/base/hasher.h"
#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

World ParseFields(const std::string& fields) {
  return ParseWorld(R"({"schema": "openr-host world 2", "name": "w")" + fields + "}", "w.json");
}

World ParseThing(const std::string& row) { return ParseFields(R"(, "things": [)" + row + "]"); }

std::string ErrorOfFields(const std::string& fields) {
  return ErrorOf([&] { ParseFields(fields); });
}

std::string ErrorOfRow(const std::string& row) {
  return ErrorOf([&] { ParseThing(row); });
}

constexpr const char* kBall = R"({"shape":"sphere","name":"b","radius_m":0.1,"centre_m":[1,0,0.1])";
constexpr const char* kStripe =
    R"({"shape":"box","name":"s","size_m":[1,0.1,0.001],"centre_m":[1,0,0],"solid":false)";

TEST(WorldLooksTest, AMovableThingHasAMass) {
  EXPECT_EQ(ParseThing(std::string(kBall) + R"(,"mass_kg":0.08})").things.at(0).mass_kg, 0.08);
  EXPECT_EQ(ParseThing(std::string(kBall) + "}").things.at(0).mass_kg, 0);
  EXPECT_EQ(ErrorOfRow(std::string(kBall) + R"(,"mass_kg":0})"),
            "w.json: things[0].mass_kg: is 0, must be 0.001 to 1000");
  EXPECT_EQ(ErrorOfRow(std::string(kBall) + R"(,"mass_kg":1e9})"),
            "w.json: things[0].mass_kg: is 1000000000, must be 0.001 to 1000");
  EXPECT_EQ(ErrorOfRow(R"({"shape":"box","name":"leaf","size_m":[1,1,0.001],"centre_m":[0,0,1],
                           "mass_kg":1})"),
            "w.json: things[0].mass_kg: belongs to 'leaf', which is 0.001 m thin; what moves must "
            "have 0.005 m");
}

TEST(WorldLooksTest, ThingsThatMoveHaveNamesOfTheirOwn) {
  const std::string ball = std::string(kBall) + R"(,"mass_kg":0.08})";
  EXPECT_EQ(ErrorOfRow(ball + "," + ball),
            "w.json: things: has two things 'b' that can move; each needs a name of its own");
  EXPECT_EQ(ParseThing(ball + "," + kBall + "}").things.size(), 2u);
}

TEST(WorldLooksTest, RobotsHaveStarts) {
  const World world =
      ParseFields(R"(, "starts": [{"place_m":[1,2],"yaw_deg":90},{"place_m":[0,0]}])");
  ASSERT_EQ(world.starts.size(), 2u);
  EXPECT_EQ(world.starts[0].x_m, 1);
  EXPECT_EQ(world.starts[0].y_m, 2);
  EXPECT_DOUBLE_EQ(world.starts[0].yaw_rad, Radians(90));
  EXPECT_EQ(StartOf(world, 1).yaw_rad, 0);
  EXPECT_EQ(
      ErrorOf([&] { StartOf(world, 2); }),
      "the world 'w' has places for 2 robots (starts); robot 2 has none; add a place, or take "
      "fewer robots");
  EXPECT_EQ(StartOf(World{}, 0).y_m, 0);
  EXPECT_EQ(StartOf(World{}, 1).y_m, 0.5);
  EXPECT_EQ(StartOf(World{}, 2).y_m, -0.5);
  EXPECT_EQ(ErrorOfFields(R"(, "starts": [{"place_m":[1]}])"),
            "w.json: starts[0].place_m: has 1 numbers, must have x and y");
  EXPECT_EQ(ErrorOfFields(R"(, "starts": [{"place_m":[1,2],"yaw":90}])"),
            "w.json: starts[0]: 'yaw' is unknown; known here: place_m, yaw_deg");
}

TEST(WorldLooksTest, AnUnknownFieldOfTheLightIsRefused) {
  EXPECT_EQ(ErrorOfFields(R"(, "light": {"colour":[1,1,1]})"),
            "w.json: light: 'colour' is unknown; known here: direction_deg, ambient");
}

TEST(WorldLooksTest, ARampCannotBeMoved) {
  EXPECT_EQ(ErrorOfRow(R"({"shape":"ramp","name":"r","size_m":[1,1,1],"start_m":[0,0,0],
                           "mass_kg":1})"),
            "w.json: things[0]: 'mass_kg' is unknown; known here: shape, name, colour, "
            "reflectance, size_m, start_m, yaw_deg");
}

TEST(WorldLooksTest, PaintIsNotSolid) {
  EXPECT_FALSE(ParseThing(std::string(kStripe) + "}").things.at(0).is_solid);
  EXPECT_TRUE(ParseThing(std::string(kBall) + "}").things.at(0).is_solid);
}

TEST(WorldLooksTest, PaintHasNoMassAndNoSlope) {
  EXPECT_EQ(ErrorOfRow(std::string(kStripe) + R"(,"mass_kg":1})"),
            "w.json: things[0].mass_kg: 's' is paint on the floor, which has none");
  EXPECT_EQ(ErrorOfRow(std::string(kStripe) + R"(,"rpy_deg":[0,1,0]})"),
            "w.json: things[0].rpy_deg: 's' is paint on the floor, which has none");
}

TEST(WorldLooksTest, PaintLiesOnTheFloor) {
  EXPECT_EQ(ErrorOfRow(R"({"shape":"cylinder","name":"c","radius_m":1,"height_m":0.2,
                           "centre_m":[0,0,0.1],"solid":false})"),
            "w.json: things[0].solid: 'c' is 0.2 m high and its middle at 0.1 m; paint lies on the "
            "floor, with at most 0.01 m each");
}

TEST(WorldLooksTest, SolidIsTrueOrFalse) {
  EXPECT_EQ(ErrorOfRow(R"({"shape":"box","name":"s","size_m":[1,1,1],"centre_m":[1,0,0],
                           "solid":"no"})"),
            "w.json: things[0].solid: must be true or false, is \"no\"");
}

TEST(WorldLooksTest, ReflectanceIsAShare) {
  const World world = ParseFields(R"(, "floor_reflectance": 0.5, "things": [)" +
                                  std::string(kBall) + R"(,"reflectance":0.25}])");
  EXPECT_EQ(world.floor_reflectance, 0.5);
  EXPECT_EQ(world.things.at(0).reflectance, 0.25);
  EXPECT_EQ(ErrorOfRow(std::string(kBall) + R"(,"reflectance":1.5})"),
            "w.json: things[0].reflectance: is 1.5, must be 0 to 1");
  EXPECT_EQ(ErrorOfFields(R"(, "floor_reflectance": -1)"),
            "w.json: floor_reflectance: is -1, must be 0 to 1");
}

TEST(WorldLooksTest, TheFloorHasAColour) {
  EXPECT_EQ(ParseFields(R"(, "floor_colour": [0.1, 0.5, 0.2])").floor_colour,
            Vector3d(0.1, 0.5, 0.2));
  EXPECT_EQ(ErrorOfFields(R"(, "floor_colour": [0, 0, 9])"),
            "w.json: floor_colour: is [0, 0, 9]; red, green and blue must be 0 to 1");
}

TEST(WorldLooksTest, LightComesFromAnAzimuthAndAnElevation) {
  const World world = ParseFields(R"(, "light": {"direction_deg": [90, 30], "ambient": 0.4})");
  EXPECT_TRUE(world.to_light.isApprox(Vector3d(0, std::sqrt(0.75), 0.5), 1e-12));
  EXPECT_EQ(world.ambient, 0.4);
  EXPECT_EQ(ParseFields(R"(, "light": {})").to_light, World().to_light);
}

TEST(WorldLooksTest, LightFromBelowIsRefused) {
  EXPECT_EQ(ErrorOfFields(R"(, "light": {"direction_deg": [0, -5]})"),
            "w.json: light.direction_deg: is [0, -5]; azimuth must be -360 to 360, elevation 0 to "
            "90");
  EXPECT_EQ(ErrorOfFields(R"(, "light": {"ambient": 2})"),
            "w.json: light.ambient: is 2, must be 0 to 1");
}

uint64_t HashOf(const World& world) {
  Hasher hasher;
  HashWorld(world, &hasher);
  return hasher.Digest();
}

// The hash has all that moves, stops or reflects, and nothing that only a camera sees.
TEST(WorldLooksTest, TheHashKnowsMatterAndNotLooks) {
  World world = ParseThing(std::string(kBall) + "}");
  const uint64_t plain = HashOf(world);
  world.floor_colour = Vector3d(1, 0, 0);
  world.ambient = 0.1;
  world.things[0].colour = Vector3d(0, 0, 1);
  EXPECT_EQ(HashOf(world), plain);
  World other = world;
  other.things[0].mass_kg = 1;
  EXPECT_NE(HashOf(other), plain);
  other = world;
  other.things[0].reflectance = 0.5;
  EXPECT_NE(HashOf(other), plain);
  other = world;
  other.things[0].is_solid = false;
  EXPECT_NE(HashOf(other), plain);
  other = world;
  other.floor_reflectance = 0.5;
  EXPECT_NE(HashOf(other), plain);
}

// 4.2 m x 2.7 m between the borders, and the ball at rest on the floor, away from the dog.
TEST(WorldLooksTest, TheFieldOf2004IsRead) {
  const World field = LoadWorld(OPENR_WORLD_DIR "/field-2004.json");
  EXPECT_NEAR(CastRay(field, field.things, {0, 1, 0.05}, {1, 0, 0}, 5).distance_m, 2.1, 1e-12);
  EXPECT_NEAR(CastRay(field, field.things, {0, 0, 0.05}, {0, 1, 0}, 5).distance_m, 1.35, 1e-12);
  const WorldThing& ball = field.things.back();
  EXPECT_EQ(ball.name, "ball");
  EXPECT_GT(ball.mass_kg, 0);
  EXPECT_EQ(ball.centre_m, Vector3d(1, 0, ball.size_m.z() / 2));
}

TEST(WorldLooksTest, TheEmptyRoomIsFourByFourMetres) {
  const World room = LoadWorld(OPENR_WORLD_DIR "/empty-room.json");
  for (const Vector3d& direction :
       {Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, -1, 0)})
    EXPECT_NEAR(CastRay(room, room.things, {0, 0, 0.2}, direction, 5).distance_m, 2, 1e-12);
}

}  // namespace
}  // namespace openr_host
