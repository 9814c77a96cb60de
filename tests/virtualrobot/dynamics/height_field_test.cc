// Contacts with heightfields, and rays that meet them; checked by hand.
#include "virtualrobot/dynamics/height_field.h"

#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/worlds/height_grid.h"

namespace openr_host {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

World FieldWith(const std::string& row) {
  return ParseWorld(R"({"schema":"openr-host world 2","name":"w","things":[)" + row + "]}", "w");
}

// Ground of 2 m x 2 m that rises along x from 0 to 1 m.
WorldThing Slope() {
  return FieldWith(R"({"shape":"heightfield","name":"s","size_m":[2,2],"centre_m":[0,0,0],
                       "heights_m":[[0,0.5,1],[0,0.5,1],[0,0.5,1]]})")
      .things.at(0);
}

// A valley along y with sides of 45 degrees: its bottom is at x = 0.
WorldThing Valley() {
  return FieldWith(R"({"shape":"heightfield","name":"v","size_m":[2,2],"centre_m":[0,0,0],
                       "heights_m":[[1,0,1],[1,0,1]]})")
      .things.at(0);
}

std::string ErrorOfHeights(const std::string& fields) {
  return ErrorOf([&] {
    FieldWith(R"({"shape":"heightfield","name":"h","centre_m":[0,0,0],)" + fields + "}");
  });
}

TEST(HeightFieldTest, RowsAreReadFromTheRightToTheLeft) {
  const WorldThing thing = FieldWith(R"({"shape":"heightfield","name":"h","size_m":[2,1],
      "centre_m":[1,0,0.1],"heights_m":[[0,0,0],[0.1,0.2,0.4]]})")
                               .things.at(0);
  EXPECT_EQ(thing.size_m, Vector3d(2, 1, 0.4));
  EXPECT_TRUE(thing.centre_m.isApprox(Vector3d(1, 0, 0.3)));
  EXPECT_TRUE((thing.centre_m + PointOfGrid(thing, 2, 1)).isApprox(Vector3d(2, 0.5, 0.5)));
  EXPECT_TRUE((thing.centre_m + PointOfGrid(thing, 1, 0)).isApprox(Vector3d(1, -0.5, 0.1)));
}

TEST(HeightFieldTest, MistakesAreNamedWithTheirPlace) {
  EXPECT_EQ(ErrorOfHeights(R"("size_m":[0,1],"heights_m":[[0,1],[0,1]])"),
            "w: things[0].size_m: heightfield 'h' is 0 x 1 m, edges must be > 0");
  EXPECT_EQ(ErrorOfHeights(R"("size_m":[1,1],"heights_m":[[0,1]])"),
            "w: things[0].heights_m: has 1 rows of 2 numbers, must have 2 to 64 of each");
  EXPECT_EQ(ErrorOfHeights(R"("size_m":[1,1],"heights_m":[[0,1],[0]])"),
            "w: things[0].heights_m[1]: must have 2 numbers, has 1");
  EXPECT_EQ(ErrorOfHeights(R"("size_m":[1,1],"heights_m":[[0,1],[0,-1]])"),
            "w: things[0].heights_m[1]: has -1, heights over the base must be >= 0");
  EXPECT_EQ(ErrorOfHeights(R"("size_m":[1,1],"heights_m":[[0,0],[0,0]])"),
            "w: things[0].heights_m: are all 0; one must be > 0");
}

TEST(HeightFieldTest, ARayMeetsTheSlope) {
  const WorldThing slope = Slope();
  const auto distance = [&](const Vector3d& p_W, const Vector3d& direction_W) {
    return CastRay(World(), {slope}, p_W, direction_W, 5).distance_m;
  };
  EXPECT_NEAR(distance({0.3, 0.2, 2}, {0, 0, -1}), 2 - 0.65, 1e-12);
  EXPECT_NEAR(distance({-3, -0.3, 0.4}, {1, 0, 0}), 3 - 0.2, 1e-12);
  EXPECT_NEAR(distance({3, 0.1, 0.4}, {-1, 0, 0}), 2, 1e-12);   // the wall at its end
  EXPECT_NEAR(distance({0, 0.1, 0.4}, {0, 0, 1}), 0, 1e-12);    // inside
  EXPECT_NEAR(distance({-0.9, 2, 0.5}, {0, -1, 0}), 5, 1e-12);  // over it
  EXPECT_NEAR(distance({-0.5, -1.5, 1.25}, {0, 0.8, -0.6}), 5.0 / 3, 1e-12);
}

TEST(HeightFieldTest, ABallOnTheSlopeTouchesAlongItsNormal) {
  const Vector3d normal = Vector3d(-0.5, 0, 1).normalized();
  const Vector3d on_slope(0.1, 0.23, 0.55);
  std::vector<TouchPoint> points;
  TouchBallOnHeights(on_slope + 0.09 * normal, 0.1, Slope(), &points);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_TRUE(points[0].normal_W.isApprox(normal, 1e-12));
  EXPECT_NEAR(points[0].depth_m, 0.01, 1e-12);
  EXPECT_TRUE(points[0].p_W.isApprox(on_slope - 0.01 * normal, 1e-12));
  points.clear();
  TouchBallOnHeights(on_slope + 0.11 * normal, 0.1, Slope(), &points);
  EXPECT_TRUE(points.empty());
}

TEST(HeightFieldTest, ABallWhoseCentreIsBelowTheSurfaceIsPushedUp) {
  const Vector3d normal = Vector3d(-0.5, 0, 1).normalized();
  std::vector<TouchPoint> points;
  TouchBallOnHeights(Vector3d(0.1, 0.23, 0.55) - 0.02 * normal, 0.1, Slope(), &points);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_TRUE(points[0].normal_W.isApprox(normal, 1e-12));
  EXPECT_NEAR(points[0].depth_m, 0.12, 1e-12);
}

TEST(HeightFieldTest, ABallInTheValleyTouchesBothSides) {
  std::vector<TouchPoint> points;
  TouchBallOnHeights({0, 0.2, 0.14}, 0.1, Valley(), &points);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR(points[0].normal_W.x() + points[1].normal_W.x(), 0, 1e-12);
  for (const TouchPoint& point : points) {
    EXPECT_NEAR(point.normal_W.z(), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(point.depth_m, 0.1 - 0.14 * std::sqrt(0.5), 1e-12);
  }
}

// A ridge of 0.1 m along y between slopes of 1 in 10.  The plane of the other slope goes on above
// the slope on which the ball lies, but that slope ends at the ridge.
TEST(HeightFieldTest, ABallBesideARidgeTouchesOneSlope) {
  const WorldThing along_y = FieldWith(R"({"shape":"heightfield","name":"r","size_m":[2,2],
      "centre_m":[0,0,0],"heights_m":[[0,0.1,0],[0,0.1,0],[0,0.1,0]]})")
                                 .things.at(0);
  WorldThing along_x = along_y;
  along_x.R_WT = RotationFromRpy({0, 0, Radians(90)});
  const WorldThing other_grid = FieldWith(R"({"shape":"heightfield","name":"r","size_m":[2,2],
      "centre_m":[0,0,0],"heights_m":[[0,0,0],[0.1,0.1,0.1],[0,0,0]]})")
                                    .things.at(0);
  for (const double side : {-1.0, 1.0}) {
    for (const double along : {-0.7, -0.3, 0.2, 0.6}) {
      const Vector3d normal = Vector3d(side * 0.1, 0, 1).normalized();
      const Vector3d centre = Vector3d(side * 0.06, along, 0.094) + 0.09 * normal;
      const auto turned = [](const Vector3d& v) { return Vector3d(-v.y(), v.x(), v.z()); };
      for (const WorldThing* const ridge :
           std::initializer_list<const WorldThing*>{&along_y, &along_x, &other_grid}) {
        const bool is_turned = ridge != &along_y;
        std::vector<TouchPoint> points;
        TouchBallOnHeights(is_turned ? turned(centre) : centre, 0.1, *ridge, &points);
        ASSERT_EQ(points.size(), 1u) << side << " " << along;
        EXPECT_TRUE(points[0].normal_W.isApprox(is_turned ? turned(normal) : normal, 1e-9));
        EXPECT_GT(points[0].depth_m, 0.009);
        EXPECT_LT(points[0].depth_m, 0.011);
      }
    }
  }
}

TEST(HeightFieldTest, ABallTouchesTheWallAtTheEdge) {
  std::vector<TouchPoint> points;
  TouchBallOnHeights({1.08, 0, 0.5}, 0.1, Slope(), &points);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_TRUE(points[0].normal_W.isApprox(Vector3d::UnitX(), 1e-12));
  EXPECT_NEAR(points[0].depth_m, 0.02, 1e-12);
  points.clear();
  TouchBallOnHeights({-1.08, 0, 0.5}, 0.1, Slope(), &points);  // the slope is 0 there
  EXPECT_TRUE(points.empty());
}

TEST(HeightFieldTest, ATurnedFieldTurnsItsContacts) {
  WorldThing slope = Slope();
  slope.R_WT = RotationFromRpy({0, 0, Radians(90)});
  slope.centre_m += Vector3d(3, 0, 0);
  const Vector3d normal = Vector3d(0, -0.5, 1).normalized();
  std::vector<TouchPoint> points;
  TouchBallOnHeights(Vector3d(3, 0.1, 0.55) + 0.09 * normal, 0.1, slope, &points);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_TRUE(points[0].normal_W.isApprox(normal, 1e-12));
}

// An upright box of 0.2 m whose lower corners at x = 0.3 are 0.01 m below the slope of one half.
TEST(HeightFieldTest, CornersOfABoxTouchTheSlope) {
  std::vector<TouchPoint> points;
  TouchBoxOnHeights({0.2, 0.25, 0.65 - 0.01 + 0.1}, Matrix3d::Identity(), {0.2, 0.2, 0.2}, Slope(),
                    &points);
  ASSERT_EQ(points.size(), 2u);
  for (const TouchPoint& point : points) {
    EXPECT_NEAR(point.p_W.x(), 0.3, 1e-12);
    EXPECT_NEAR(point.depth_m, 0.01 * 2 / std::sqrt(5), 1e-12);
    EXPECT_TRUE(point.normal_W.isApprox(Vector3d(-0.5, 0, 1).normalized(), 1e-12));
  }
}

// Level ground of 4 m x 4 m at a height of 1 m.
WorldThing Level() {
  return FieldWith(R"({"shape":"heightfield","name":"l","size_m":[4,4],"centre_m":[0,0,0],
                       "heights_m":[[1,1],[1,1]]})")
      .things.at(0);
}

// All numbers of this test are exact in binary.
TEST(HeightFieldTest, WhatOnlyReachesTheGroundDoesNotTouchIt) {
  std::vector<TouchPoint> points;
  TouchBoxOnHeights({0.5, 0.5, 1.25}, Matrix3d::Identity(), {0.5, 0.5, 0.5}, Level(), &points);
  TouchBallOnHeights({0.5, 0.5, 1.25}, 0.25, Level(), &points);
  TouchBoxOnHeights({0, 0.25, 0.875}, Matrix3d::Identity(), {0.5, 0.5, 0.5}, Slope(), &points);
  EXPECT_TRUE(points.empty());
}

// A box of 0.2 m x 0.4 m x 0.6 m, 0.01 m deep in level ground, whichever of its sides is below.
TEST(HeightFieldTest, TheFourLowerCornersOfABoxTouchLevelGround) {
  for (const double roll_deg : {0.0, 90.0, 180.0, 270.0}) {
    const Matrix3d R_WB = RotationFromRpy({Radians(roll_deg), 0, 0});
    const Vector3d half = (R_WB * Vector3d(0.1, 0.2, 0.3)).cwiseAbs();
    std::vector<TouchPoint> points;
    TouchBoxOnHeights({0.5, 0.6, 1 - 0.01 + half.z()}, R_WB, {0.2, 0.4, 0.6}, Level(), &points);
    ASSERT_EQ(points.size(), 4u) << roll_deg;
    for (const double x : {0.5 - half.x(), 0.5 + half.x()}) {
      for (const double y : {0.6 - half.y(), 0.6 + half.y()}) {
        const Vector3d corner(x, y, 0.99);
        EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                                [&](const TouchPoint& point) {
                                  return point.p_W.isApprox(corner, 1e-12) &&
                                         point.normal_W.isApprox(Vector3d::UnitZ(), 1e-12) &&
                                         std::fabs(point.depth_m - 0.01) < 1e-12;
                                }))
            << roll_deg << " degrees: " << corner.transpose();
      }
    }
  }
}

TEST(HeightFieldTest, APeakTouchesTheFaceAboveIt) {
  const WorldThing peak = FieldWith(R"({"shape":"heightfield","name":"p","size_m":[2,2],
      "centre_m":[0,0,0],"heights_m":[[0,0,0],[0,0.3,0],[0,0,0]]})")
                              .things.at(0);
  std::vector<TouchPoint> points;
  TouchBoxOnHeights({0.01, 0.02, 0.29 + 0.1}, Matrix3d::Identity(), {0.4, 0.4, 0.2}, peak, &points);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_TRUE(points[0].p_W.isApprox(Vector3d(0, 0, 0.3), 1e-12));
  EXPECT_TRUE(points[0].normal_W.isApprox(Vector3d::UnitZ(), 1e-12));
  EXPECT_NEAR(points[0].depth_m, 0.01, 1e-12);
}

TEST(HeightFieldTest, ABoxThatIsFarAwayTouchesNothing) {
  std::vector<TouchPoint> points;
  TouchBoxOnHeights({0, 0, 2}, Matrix3d::Identity(), {0.2, 0.2, 0.2}, Slope(), &points);
  TouchBoxOnHeights({4, 0, 0.2}, Matrix3d::Identity(), {0.2, 0.2, 0.2}, Slope(), &points);
  TouchBallOnHeights({0, 0, 3}, 0.1, Slope(), &points);
  EXPECT_TRUE(points.empty());
}

}  // namespace
}  // namespace openr_host
