// Tests of the pictures that a camera takes of a world: places, sizes, hiding, clipping; and golden
// pictures.
#include "virtualrobot/camera/rendered_world.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/determinism/picture_hash.h"
#include "tests/virtualrobot/body_harness.h"
#include "tests/virtualrobot/follow_body.h"
#include "virtualrobot/camera/camera.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

constexpr int kSeenWidth = 352, kSeenHeight = 288;
const Vector3d kPureRed(1, 0, 0), kPureGreen(0, 1, 0), kPureBlue(0, 0, 1);

// A camera with a right angle of view in both directions: a ray through pixel x goes to the side by
// 1 - (2 x + 1) / width for each metre forward.
class RenderedWorldTest : public testing::Test {
 protected:
  RenderedWorldTest() {
    world.floor_colour = Vector3d(0.5, 0.5, 0.5);
    world.ambient = 1;  // every face has the colour of its thing
    shot.X_WC.translation() = Vector3d(0, 0, 1);
    shot.fov_h_rad = shot.fov_v_rad = Radians(90);
  }
  void Look(const Vector3d& p_W, double roll_deg, double pitch_deg, double yaw_deg) {
    shot.X_WC.translation() = p_W;
    shot.X_WC.linear() = RotationFromRpy({Radians(roll_deg), Radians(pitch_deg), Radians(yaw_deg)});
  }
  WorldThing& Add(ThingShape shape, const Vector3d& size_m, const Vector3d& centre_m,
                  const Vector3d& colour) {
    WorldThing thing;
    thing.shape = shape;
    thing.size_m = size_m;
    thing.centre_m = centre_m;
    thing.colour = colour;
    world.things.push_back(thing);
    return world.things.back();
  }
  WorldThing& AddBox(const Vector3d& size_m, const Vector3d& centre_m, const Vector3d& colour) {
    return Add(ThingShape::kBox, size_m, centre_m, colour);
  }
  void Draw() { DrawWorld(shot, world, world.things, &canvas, &picture); }
  RgbBytes At(int x, int y) {
    const uint8_t* const rgb = picture.At(x, y);
    return {rgb[0], rgb[1], rgb[2]};
  }
  // Returns the number of pixels with the colour, in full light.
  int Count(const Vector3d& colour) {
    int count = 0;
    for (int y = 0; y < kSeenHeight; ++y) {
      for (int x = 0; x < kSeenWidth; ++x) count += At(x, y) == RgbOf(colour, 1) ? 1 : 0;
    }
    return count;
  }

  World world;
  CameraShot shot;
  Canvas canvas;
  Picture picture{kSeenWidth, kSeenHeight,
                  std::vector<uint8_t>(size_t{kSeenWidth} * kSeenHeight * 3)};
};

TEST_F(RenderedWorldTest, TheHorizonIsLevelWithTheLens) {
  Draw();
  EXPECT_NE(At(0, kSeenHeight / 2 - 1), At(0, kSeenHeight / 2));
  EXPECT_EQ(At(0, kSeenHeight / 2), RgbOf(world.floor_colour, 1));
  EXPECT_EQ(At(kSeenWidth - 1, kSeenHeight - 1), RgbOf(world.floor_colour, 1));
  EXPECT_EQ(Count(world.floor_colour), kSeenWidth * kSeenHeight / 2);
}

TEST_F(RenderedWorldTest, TheHorizonTiltsWithTheHead) {
  Look({0, 0, 1}, 45, 0, 0);  // its right side is down, so the left of the picture shows the sky
  Draw();
  EXPECT_EQ(At(kSeenWidth - 1, kSeenHeight / 2 + 10), RgbOf(world.floor_colour, 1));
  EXPECT_NE(At(0, kSeenHeight / 2 - 10), RgbOf(world.floor_colour, 1));
  Look({0, 0, 1}, 0, 80, 0);
  Draw();
  EXPECT_EQ(Count(world.floor_colour), kSeenWidth * kSeenHeight);
  Look({0, 0, 1}, 0, -80, 0);
  Draw();
  EXPECT_EQ(Count(world.floor_colour), 0);
}

// A square of 1 m at 2 m is a quarter of the picture wide and high, in its middle.
TEST_F(RenderedWorldTest, ABoxHasItsPlaceAndSize) {
  AddBox({0.2, 1, 1}, {2.1, 0, 1}, kPureRed);
  Draw();
  EXPECT_EQ(Count(kPureRed), kSeenWidth / 4 * kSeenHeight / 4);
  EXPECT_EQ(At(kSeenWidth * 3 / 8, kSeenHeight * 3 / 8), RgbOf(kPureRed, 1));
  EXPECT_EQ(At(kSeenWidth * 5 / 8 - 1, kSeenHeight * 5 / 8 - 1), RgbOf(kPureRed, 1));
}

TEST_F(RenderedWorldTest, LeftIsLeftAndUpIsUp) {
  AddBox({0.1, 0.4, 0.4}, {2, 1, 1}, kPureRed);
  AddBox({0.1, 0.4, 0.4}, {2, 0, 2}, kPureBlue);
  Draw();
  EXPECT_EQ(At(kSeenWidth / 4, kSeenHeight / 2 - 1), RgbOf(kPureRed, 1));
  EXPECT_EQ(At(kSeenWidth / 2, kSeenHeight / 4), RgbOf(kPureBlue, 1));
}

// The outline of a ball of radius r at distance d has the slope r / sqrt(d^2 - r^2).
TEST_F(RenderedWorldTest, ABallIsADisk) {
  Add(ThingShape::kSphere, Vector3d::Constant(0.6), {1, 0, 1}, kPureRed);
  Draw();
  const double slope = 0.3 / std::sqrt(1 - 0.09);
  EXPECT_NEAR(Count(kPureRed), kPi * slope * slope * kSeenWidth * kSeenHeight / 4, 100);
  const int left = static_cast<int>(kSeenWidth / 2 * (1 - slope));
  EXPECT_EQ(At(left + 1, kSeenHeight / 2), RgbOf(kPureRed, 1));
  EXPECT_NE(At(left - 1, kSeenHeight / 2), RgbOf(kPureRed, 1));
}

// At the edge of the picture a ball is an ellipse, whose pixels are found, too.
TEST_F(RenderedWorldTest, ABallAtTheEdgeReachesTheEdge) {
  Add(ThingShape::kSphere, Vector3d::Constant(0.4), {1, 1, 1}, kPureRed);
  Draw();
  EXPECT_EQ(At(0, kSeenHeight / 2), RgbOf(kPureRed, 1));
}

TEST_F(RenderedWorldTest, ACylinderStandsAndLies) {
  Add(ThingShape::kCylinder, {0.4, 0.4, 1}, {2, 0, 1}, kPureRed);
  Draw();
  const int standing = Count(kPureRed);
  EXPECT_NEAR(standing, 0.4 / 4 * kSeenWidth * 1 / 4 * kSeenHeight, 600);
  EXPECT_EQ(At(kSeenWidth / 2, kSeenHeight * 3 / 8 + 4), RgbOf(kPureRed, 1));
  world.things[0].R_WT = RotationFromRpy({0, Radians(90), 0});  // its round end is seen
  Draw();
  // The end is a circle of 0.2 m at 1.5 m, and its side is behind it.
  EXPECT_NEAR(Count(kPureRed), kPi * 0.2 * 0.2 / (1.5 * 1.5) * kSeenWidth * kSeenHeight / 4, 40);
}

TEST_F(RenderedWorldTest, ANearThingHidesAFarOneInAnyOrder) {
  AddBox({0.1, 1, 1}, {2, 0, 1}, kPureRed);
  AddBox({0.1, 3, 3}, {3, 0, 1}, kPureBlue);
  Draw();
  EXPECT_EQ(At(kSeenWidth / 2, kSeenHeight / 2 - 2), RgbOf(kPureRed, 1));
  std::swap(world.things[0], world.things[1]);
  Draw();
  EXPECT_EQ(At(kSeenWidth / 2, kSeenHeight / 2 - 2), RgbOf(kPureRed, 1));
}

TEST_F(RenderedWorldTest, ThingsThatCrossAreDividedWhereTheyMeet) {
  AddBox({0.4, 0.4, 0.4}, {2, 0, 1}, kPureRed);
  Add(ThingShape::kSphere, Vector3d::Constant(0.5), {2, 0, 1}, kPureBlue);
  Draw();
  EXPECT_EQ(At(kSeenWidth / 2, kSeenHeight / 2 - 1),
            RgbOf(kPureBlue, 1));  // the ball bulges out of the face
  EXPECT_GT(Count(kPureRed), 0);   // the edges stick out of the ball
}

TEST_F(RenderedWorldTest, ThingsBehindTheLensAreNotSeen) {
  AddBox({1, 1, 1}, {-2, 0, 1}, kPureRed);
  Add(ThingShape::kSphere, Vector3d::Constant(1), {-2, 0, 1}, kPureBlue);
  Draw();
  EXPECT_EQ(Count(kPureRed) + Count(kPureBlue), 0);
}

// A board that reaches from behind the lens to far ahead is seen from the near plane on.
TEST_F(RenderedWorldTest, AFaceThatPassesTheLensIsCut) {
  AddBox({20, 0.1, 0.1}, {0, 0, 0.9}, kPureRed);
  Draw();
  EXPECT_EQ(At(kSeenWidth / 2, kSeenHeight - 1), RgbOf(kPureRed, 1));
  EXPECT_NE(At(kSeenWidth / 2, kSeenHeight / 2 - 3), RgbOf(kPureRed, 1));
}

TEST_F(RenderedWorldTest, AThingAroundTheLensIsNotSeen) {
  AddBox({1, 1, 1}, {0, 0, 1}, kPureRed);
  Add(ThingShape::kSphere, Vector3d::Constant(1), {0, 0, 1}, kPureBlue);
  Draw();
  EXPECT_EQ(Count(kPureRed) + Count(kPureBlue), 0);
}

TEST_F(RenderedWorldTest, PartsBelowTheFloorAreNotSeen) {
  Look({0, 0, 1}, 0, 45, 0);
  AddBox({0.2, 0.2, 0.2}, {1, -0.3, -0.11}, kPureRed);
  Add(ThingShape::kSphere, Vector3d::Constant(0.2), {1, 0.3, -0.11}, kPureBlue);
  Draw();
  EXPECT_EQ(Count(kPureRed) + Count(kPureBlue), 0);
  world.things[0].centre_m.z() = world.things[1].centre_m.z() = -0.05;
  Draw();
  EXPECT_GT(Count(kPureRed), 100);
  EXPECT_GT(Count(kPureBlue), 100);
}

TEST_F(RenderedWorldTest, LaterPaintCoversEarlierPaintAndThingsHideBoth) {
  Look({0, 0, 1}, 0, 45, 0);
  AddBox({0.5, 0.5, 0.001}, {1, 0, 0}, kPureRed).is_solid = false;
  Add(ThingShape::kCylinder, {0.2, 0.2, 0.001}, {1, 0, 0}, kPureBlue).is_solid = false;
  Draw();
  EXPECT_EQ(At(kSeenWidth / 2, kSeenHeight / 2), RgbOf(kPureBlue, 1));
  EXPECT_GT(Count(kPureRed), Count(kPureBlue));
  world.things.insert(world.things.begin(), world.things[0]);
  world.things[0].colour = kPureGreen;
  world.things[0].is_solid = true;
  world.things[0].size_m = Vector3d(0.5, 0.5, 0.1);
  Draw();
  EXPECT_EQ(At(kSeenWidth / 2, kSeenHeight / 2), RgbOf(kPureGreen, 1));
}

// Light from above: the upper face has all of it, a side and the lower half of a ball the ambient.
TEST_F(RenderedWorldTest, FacesAreLitByTheirDirection) {
  world.to_light = Vector3d::UnitZ();
  world.ambient = 0.5;
  Look({0, 0, 1}, 0, 30, 0);
  AddBox({0.4, 0.4, 0.4}, {1, 0, 0.3}, kPureRed);
  Add(ThingShape::kSphere, Vector3d::Constant(0.4), {1, 0.5, 0.4}, kPureBlue);
  Draw();
  EXPECT_GT(Count(kPureRed), 500);
  EXPECT_GT(Count(kPureRed * 0.5), 500);
  EXPECT_GT(Count(kPureBlue * 0.5), 20);
  EXPECT_GT(Count(kPureBlue), 2);
}

// The parts of the robot are around the origin: from the side, its trunk is seen and its head not.
TEST_F(RenderedWorldTest, TheRobotSeesItsTrunkAndNotItsHead) {
  const RobotModel& model = Ers210();
  const FollowBody body(model);
  Look({0.02, -0.5, 0.05}, 0, 0, 90);
  shot.body = &body;
  RenderedWorld source(model);
  ASSERT_EQ(source.Capture(shot, &picture), "");
  const auto column = [&](double x_m) {
    return static_cast<int>(kSeenWidth / 2 * (1 + (x_m - 0.02) / 0.5));
  };
  const auto row = [](double z_m) {
    return static_cast<int>(kSeenHeight / 2 * (1 - (z_m - 0.05) / 0.5));
  };
  const RgbBytes background = At(0, 0);
  EXPECT_NE(At(column(0), row(0.03)), background);
  EXPECT_EQ(At(column(0.13), row(0.12)), background);   // head
  EXPECT_EQ(At(column(0.12), row(0.075)), background);  // mouth
}

// The colours of the field of 2004, found by tables as in docs/worlds.md through all layers.
class FieldColoursTest : public testing::Test {
 protected:
  enum Channel { kOrange, kYellow, kSkyBlue };

  FieldColoursTest()
      : body(Ers210(), LoadWorld(OPENR_WORLD_DIR "/field-2004.json")),
        camera(std::make_unique<RenderedWorld>(Ers210()), Ers210().camera, 1) {
    SetTable(ocdtCHANNEL0, 255, 172, 110, 0);
    SetTable(ocdtCHANNEL1, 171, 140, 80, 0);
    SetTable(ocdtCHANNEL2, 105, 0, 255, 150);
  }
  void SetTable(OCdtChannel channel, byte cr_max, byte cr_min, byte cb_max, byte cb_min) {
    OCdtInfo info;
    info.Init(1, channel);
    for (int segment = 0; segment < 32; ++segment)
      info.Set(segment, cr_max, cr_min, cb_max, cb_min);
    ASSERT_TRUE(camera.tables().Set(info));
  }
  // Looks from the place of a standing dog.
  void LookFrom(double x_m, double y_m, double yaw_deg) {
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
    X_WB.linear() = RotationFromRpy({0, 0, Radians(yaw_deg)});
    X_WB.translation() = Vector3d(x_m, y_m, 0.1);
    body.Place(X_WB);
    ASSERT_EQ(camera.CopyColours(5, body, &colours), "");
  }
  // Returns the mean column and the number of the pixels of a channel.
  std::pair<double, int> Found(Channel channel) {
    const auto& wanted = CameraDevice::ColourOfChannel(channel);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < colours.height; ++y) {
      for (int x = 0; x < colours.width; ++x) {
        if (!std::equal(wanted.begin(), wanted.end(), colours.At(x, y))) continue;
        sum += x;
        ++count;
      }
    }
    return {sum / std::max(count, 1), count};
  }

  FollowBody body;
  CameraDevice camera;
  Picture colours;
};

TEST_F(FieldColoursTest, TheBallIsFoundBeforeTheSkyBlueGoal) {
  LookFrom(0, 0, 0);
  EXPECT_NEAR(Found(kOrange).first, 43.5, 1);
  EXPECT_NEAR(Found(kOrange).second, 40, 20);
  EXPECT_NEAR(Found(kSkyBlue).first, 43.5, 1);
  EXPECT_GT(Found(kSkyBlue).second, 200);
  EXPECT_LT(Found(kYellow).second, 15);  // at the edge of the ball, orange and green give yellow
}

TEST_F(FieldColoursTest, ABallAtTheLeftIsSeenAtTheLeft) {
  LookFrom(0.3, 0, -20);
  EXPECT_NEAR(Found(kOrange).first, 43.5 - 44 * 0.4 / 0.55, 6);
  EXPECT_GT(Found(kOrange).second, 50);
}

TEST_F(FieldColoursTest, TheYellowGoalIsBehindTheDog) {
  LookFrom(0, 0, 180);
  EXPECT_EQ(Found(kOrange).second, 0);
  EXPECT_EQ(Found(kSkyBlue).second, 0);
  EXPECT_NEAR(Found(kYellow).first, 43.5, 1);
  EXPECT_GT(Found(kYellow).second, 200);
}

// The golden pictures of tests/determinism, which check_hashes.sh compares on other compilers.
TEST(GoldenPictureTest, EveryPictureIsTheSameToTheBit) {
  std::ifstream golden(OPENR_SOURCE_DIR "/tests/determinism/golden.txt");
  int count = 0;
  for (std::string line; std::getline(golden, line);) {
    std::istringstream words(line);
    std::string kind, world, place, hash;
    if (!(words >> kind >> world >> place >> hash) || kind != "picture") continue;
    EXPECT_EQ(fmt::format("{:016x}", HashOfPicture(OPENR_SOURCE_DIR "/" + world, place)), hash)
        << world << " " << place;
    ++count;
  }
  EXPECT_GE(count, 16);
}

}  // namespace
}  // namespace openr_host
