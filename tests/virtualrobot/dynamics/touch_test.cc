// Where balls and boxes touch spheres and cylinders.
#include "virtualrobot/dynamics/touch.h"

#include <gtest/gtest.h>

#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/rotation.h"

namespace openr_host {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

WorldThing Sphere(double radius_m, const Vector3d& centre_m) {
  return {.name = "sphere",
          .shape = ThingShape::kSphere,
          .size_m = Vector3d::Constant(2 * radius_m),
          .centre_m = centre_m};
}

WorldThing Pole(double radius_m, double height_m) {
  return {.name = "pole",
          .shape = ThingShape::kCylinder,
          .size_m = {2 * radius_m, 2 * radius_m, height_m},
          .centre_m = {0, 0, height_m / 2}};
}

void ExpectPoint(const TouchPoint& point, const Vector3d& p_W, const Vector3d& normal_W,
                 double depth_m) {
  EXPECT_LT((point.p_W - p_W).norm(), 1e-12) << point.p_W.transpose();
  EXPECT_LT((point.normal_W - normal_W).norm(), 1e-12) << point.normal_W.transpose();
  EXPECT_NEAR(point.depth_m, depth_m, 1e-12);
}

TEST(TouchTest, BallOnASphere) {
  std::vector<TouchPoint> points;
  TouchBall({0, 0, 0.28}, 0.1, Sphere(0.2, {0, 0, 0}), &points);
  ASSERT_EQ(points.size(), 1u);
  ExpectPoint(points[0], {0, 0, 0.18}, {0, 0, 1}, 0.02);
  points.clear();
  TouchBall({0, 0, 0.31}, 0.1, Sphere(0.2, {0, 0, 0}), &points);
  EXPECT_TRUE(points.empty());
}

TEST(TouchTest, BallAtACylinder) {
  std::vector<TouchPoint> points;
  TouchBall({0.13, 0, 0.2}, 0.1, Pole(0.05, 0.4), &points);   // its side
  TouchBall({0, 0, 0.48}, 0.1, Pole(0.05, 0.4), &points);     // its end
  TouchBall({0.09, 0, 0.43}, 0.1, Pole(0.05, 0.4), &points);  // its rim: 0.04 and 0.03 away
  ASSERT_EQ(points.size(), 3u);
  ExpectPoint(points[0], {0.03, 0, 0.2}, {1, 0, 0}, 0.02);
  ExpectPoint(points[1], {0, 0, 0.38}, {0, 0, 1}, 0.02);
  ExpectPoint(points[2], {0.01, 0, 0.37}, {0.8, 0, 0.6}, 0.05);
}

TEST(TouchTest, FaceOfABoxAtASphere) {
  std::vector<TouchPoint> points;
  TouchBox({0, 0, 0}, Matrix3d::Identity(), {0.2, 0.2, 0.2}, Sphere(0.05, {0.14, 0.02, 0}),
           &points);
  ASSERT_EQ(points.size(), 1u);
  // The sphere has come 10 mm into the face at x = 0.1, and pushes the box to -x.
  ExpectPoint(points[0], {0.09, 0.02, 0}, {-1, 0, 0}, 0.01);
}

TEST(TouchTest, FaceOfABoxAtAPole) {
  std::vector<TouchPoint> points;
  TouchBox({0.14, 0, 0.2}, Matrix3d::Identity(), {0.2, 0.3, 0.1}, Pole(0.05, 0.4), &points);
  ASSERT_FALSE(points.empty());
  ExpectPoint(points[0], {0.05, 0, 0.2}, {1, 0, 0}, 0.01);
  for (const TouchPoint& point : points) EXPECT_GT(point.normal_W.x(), 0.99);
}

TEST(TouchTest, EdgeOfABoxAtAPole) {
  std::vector<TouchPoint> points;
  // Turned by 45 degrees, the box has an edge 0.1 * sqrt(2) ahead of its centre.
  const double reach = 0.1 * std::sqrt(2);
  TouchBox({reach + 0.04, 0, 0.2}, RotationFromRpy({0, 0, 0.25 * 3.14159265358979}),
           {0.2, 0.2, 0.1}, Pole(0.05, 0.4), &points);
  ASSERT_FALSE(points.empty());
  EXPECT_NEAR(points[0].depth_m, 0.01, 1e-6);
  EXPECT_NEAR(points[0].normal_W.x(), 1, 1e-6);
}

// The edge leans over the pole: it is nearer to the axis the higher it is, so the box is deepest at
// the rim of the upper end.
TEST(TouchTest, AnEdgeThatLeansOverAPoleTouchesItsRim) {
  const double lean = -0.1, reach = 0.1 * std::sqrt(2);
  // Place of the box at which its edge is 0.03 m from the axis at the upper end, 0.4 m high.
  const double along = (0.2 - reach * std::sin(lean)) / std::cos(lean);
  const double x = 0.03 + reach * std::cos(lean) - along * std::sin(lean);
  const Matrix3d R = RotationFromRpy({0, lean, 0}) * RotationFromRpy({0, 0, Radians(45)});
  std::vector<TouchPoint> points;
  TouchBox({x, 0, 0.2}, R, {0.2, 0.2, 1}, Pole(0.05, 0.4), &points);
  ASSERT_FALSE(points.empty());
  EXPECT_GT(points[0].depth_m, 0.013);
  for (const TouchPoint& point : points) {
    if (std::fabs(point.p_W.z() - 0.4) > 0.01) {
      EXPECT_LT(point.depth_m, 0.001) << point.p_W.transpose();
    }
  }
}

// The points of the side are found in each direction, also between the axes of the cylinder.
TEST(TouchTest, TwoPolesAsideOfEachOthersAxes) {
  WorldThing other = Pole(0.05, 0.4);
  other.centre_m += Vector3d(0.09 / std::sqrt(2), 0.09 / std::sqrt(2), 0);
  std::vector<TouchPoint> points;
  TouchCylinders(Pole(0.05, 0.4), other, &points);
  ASSERT_FALSE(points.empty());
  EXPECT_NEAR(points[0].depth_m, 0.01, 1e-12);
  EXPECT_NEAR(std::fabs(points[0].normal_W.x()), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(std::fabs(points[0].normal_W.y()), std::sqrt(0.5), 1e-9);
}

TEST(TouchTest, CornersOfABoxOnAStool) {
  std::vector<TouchPoint> points;
  TouchBox({0, 0, 0.448}, Matrix3d::Identity(), {0.1, 0.1, 0.1}, Pole(0.2, 0.4), &points);
  ASSERT_GE(points.size(), 4u);
  for (const TouchPoint& point : points) {
    EXPECT_NEAR(point.depth_m, 0.002, 1e-12);
    EXPECT_NEAR(point.normal_W.z(), 1, 1e-12);
  }
}

// The box is 2 mm deep in the end of a wide cylinder, far from its axis.
TEST(TouchTest, ABoxAsideOnAStoolIsNotPushedAside) {
  std::vector<TouchPoint> points;
  TouchBox({0.1, 0, 0.448}, Matrix3d::Identity(), {0.1, 0.1, 0.1}, Pole(0.2, 0.4), &points);
  ASSERT_GE(points.size(), 4u);
  for (const TouchPoint& point : points) {
    EXPECT_NEAR(point.depth_m, 0.002, 1e-12);
    EXPECT_NEAR(point.normal_W.z(), 1, 1e-12);
  }
}

// No edge of the box is near the pole on which it has come down.
TEST(TouchTest, AFaceRestsOnTheRimOfAPole) {
  std::vector<TouchPoint> points;
  TouchBox({0.02, 0, 0.445}, Matrix3d::Identity(), {0.2, 0.2, 0.1}, Pole(0.03, 0.4), &points);
  ASSERT_EQ(points.size(), 8u);
  for (const TouchPoint& point : points) {
    EXPECT_NEAR(point.depth_m, 0.005, 1e-12);
    EXPECT_NEAR(point.normal_W.z(), 1, 1e-12);
    EXPECT_NEAR(point.p_W.head<2>().norm(), 0.03, 1e-12);
  }
}

// All points of the rims of a pole are in the box, 8 of each end.
TEST(TouchTest, OnlyTheDeepestPointsOfABoxCount) {
  std::vector<TouchPoint> points;
  TouchBox({0, 0, 0.3}, Matrix3d::Identity(), {2, 2, 1}, Pole(0.05, 0.4), &points);
  ASSERT_EQ(points.size(), static_cast<size_t>(kBoxPointsMax));
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    EXPECT_GE(points[i].depth_m, points[i + 1].depth_m) << i;
    EXPECT_NEAR(points[i].p_W.z(), 0.4, 1e-12) << "the upper end is deeper, 0.4 m to 0.2 m";
  }
}

TEST(TouchTest, WhatIsApartDoesNotTouch) {
  std::vector<TouchPoint> points;
  TouchBox({0.16, 0, 0.2}, Matrix3d::Identity(), {0.2, 0.3, 0.1}, Pole(0.05, 0.4), &points);
  TouchBox({0, 0, 0.46}, Matrix3d::Identity(), {0.1, 0.1, 0.1}, Pole(0.2, 0.4), &points);
  TouchBox({0, 0, 0}, Matrix3d::Identity(), {0.2, 0.2, 0.2}, Sphere(0.05, {0.16, 0, 0}), &points);
  EXPECT_TRUE(points.empty());
}

}  // namespace
}  // namespace openr_host
