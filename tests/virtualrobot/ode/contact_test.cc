// Contacts with the floor and with static boxes.
#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/ode/ode_body.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

World WithBox(const Vector3d& size_m, const Vector3d& centre_m, double yaw_deg) {
  World world;
  world.things.push_back({.name = "box",
                          .size_m = size_m,
                          .centre_m = centre_m,
                          .R_WT = RotationFromRpy({0, 0, Radians(yaw_deg)})});
  return world;
}

// A standing robot is pushed sideways at its trunk.  Its weight is 15.8 N and the friction 0.6, so
// it holds against 5 N and slides at 12 N.
TEST(ContactTest, PawsHoldBelowTheFrictionLimitAndSlideAboveIt) {
  for (const double force_n : {5.0, 12.0}) {
    OdeBody body(Ers210(), World{});
    BodyHarness harness(Ers210(), &body);
    harness.StandUp();
    const double start_mm = harness.Position_mm().x();
    for (int i = 0; i < FramesIn(0.5); ++i) {
      body.Push(0, {force_n, 0, 0}, body.state().X_WB.translation() - Vector3d(0, 0, 0.1));
      harness.Frame();
    }
    const double moved_mm = harness.Position_mm().x() - start_mm;
    if (force_n < 0.6 * 15.8) {
      EXPECT_LT(moved_mm, 15);
    } else {
      EXPECT_GT(moved_mm, 100);
    }
  }
}

TEST(ContactTest, LiftedPawReadsOff) {
  OdeBody body(Ers210(), World{});
  BodyHarness harness(Ers210(), &body);
  harness.StandUp();
  harness.Command("LF_j3").target_rad = Radians(90);
  harness.Hold(0.5);
  EXPECT_FALSE(body.state().paws[0]);
}

TEST(ContactTest, RobotOnAPlatformStandsThatMuchHigher) {
  OdeBody body(Ers210(), WithBox({1, 1, 0.04}, {0, 0, -0.01}, 30));  // 10 mm above the floor
  BodyHarness harness(Ers210(), &body);
  harness.Hold(1);  // the box pushes it up
  harness.StandUp();
  EXPECT_NEAR(harness.Position_mm().z(), 147.2, 3);
  EXPECT_EQ(harness.PawsDown(), 4);
}

TEST(ContactTest, WallKeepsAPushedRobotOut) {
  OdeBody body(Ers210(), WithBox({0.1, 1, 0.4}, {0.35, 0, 0.2}, 0));
  BodyHarness harness(Ers210(), &body);
  harness.StandUp();
  for (int i = 0; i < FramesIn(2); ++i) {
    body.Push(0, {12, 0, 0}, body.state().X_WB.translation() - Vector3d(0, 0, 0.1));
    harness.Frame();
  }
  // The head reaches 147 mm ahead of the base; the wall begins at 300 mm.
  EXPECT_LT(harness.Position_mm().x(), 300 - 140);
}

TEST(ContactTest, RoundThingsKeepAPushedRobotOut) {
  for (const ThingShape shape : {ThingShape::kSphere, ThingShape::kCylinder}) {
    World world;
    const double across_m = 0.3;
    world.things.push_back({.name = "thing",
                            .shape = shape,
                            .size_m = Vector3d::Constant(across_m),
                            .centre_m = {0.5, 0, across_m / 2}});
    OdeBody body(Ers210(), world);
    BodyHarness harness(Ers210(), &body);
    harness.StandUp();
    for (int i = 0; i < FramesIn(2); ++i) {
      body.Push(0, {12, 0, 0}, body.state().X_WB.translation() - Vector3d(0, 0, 0.1));
      harness.Frame();
    }
    // The head reaches 147 mm ahead of the base; the thing begins at 350 mm.
    EXPECT_LT(harness.Position_mm().x(), 350 - 130);
    EXPECT_GT(harness.Position_mm().x(), 100);
  }
}

// The robot lies on a ramp of 10 degrees and stays there; with little friction it slides down.
TEST(ContactTest, ARampHoldsWhatTheFrictionHolds) {
  for (const double friction : {0.6, 0.05}) {
    World world{.name = "ramp", .floor_friction = friction, .things = {}};
    world.things.push_back({.name = "ramp",
                            .size_m = {4, 2, 0.1},
                            .centre_m = {0, 0, 0.2},
                            .R_WT = RotationFromRpy({0, Radians(10), 0})});
    RestingPose pose;
    pose.X_WB.linear() = world.things[0].R_WT;
    pose.X_WB.translation() =
        Vector3d(0, 0, 0.2) + world.things[0].R_WT * Vector3d(0, 0, 0.05 + 0.06);
    OdeBody body(Ers210(), world, pose, Ers210().PostureAngles("sleep"));
    BodyHarness harness(Ers210(), &body);
    harness.Hold(1);
    const double start_mm = harness.Position_mm().x();
    harness.Hold(1);
    const double slid_mm = harness.Position_mm().x() - start_mm;
    if (friction > 0.1) {
      EXPECT_NEAR(slid_mm, 0, 5);
    } else {
      EXPECT_GT(slid_mm, 300);
    }
  }
}

}  // namespace
}  // namespace openr_host
