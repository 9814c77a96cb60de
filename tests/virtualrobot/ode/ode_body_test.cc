// Making an ODE body, its refusals and its independence of other bodies.  The other tests in this
// folder are about its movements.
#include "virtualrobot/ode/ode_body.h"

#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"

namespace openr_host {
namespace {

TEST(OdeBodyTest, StartsInTheSleepingPostureOnTheFloor) {
  OdeBody body(Ers210(), World{});
  BodyHarness harness(Ers210(), &body);
  EXPECT_NEAR(harness.AngleDegrees("LF_j1"), 60, 1e-9);
  EXPECT_NEAR(harness.AngleDegrees("RH_j3"), 147, 1e-9);
  EXPECT_NEAR(harness.Position_mm().z(), 57.8, 0.1);
  EXPECT_EQ(body.state().v_WB.norm(), 0);
}

// Head and legs sink to the floor and stay there, because no servo drives them.
TEST(OdeBodyTest, LimpRobotSagsAndComesToRestWhereItLay) {
  OdeBody body(Ers210(), World{});
  BodyHarness harness(Ers210(), &body);
  harness.Hold(10);
  const Eigen::Vector3d at_10s_mm = harness.Position_mm();
  EXPECT_LT(at_10s_mm.head<2>().norm(), 5);
  EXPECT_NEAR(at_10s_mm.z(), 57.8, 8);
  EXPECT_LT(std::fabs(harness.RpyDegrees().x()), 0.5);
  EXPECT_LT(body.state().v_WB.norm(), 0.001);
  harness.Hold(10);
  EXPECT_LT((harness.Position_mm() - at_10s_mm).norm(), 0.5);
}

TEST(OdeBodyTest, AStandingRobotFallsDownWhenItsJointsGoLimp) {
  OdeBody body(Ers210(), World{});
  BodyHarness harness(Ers210(), &body);
  harness.StandUp();
  EXPECT_GT(harness.Position_mm().z(), 130);
  for (JointCommand& command : harness.commands) command.enabled = false;
  harness.Hold(1);
  EXPECT_LT(harness.Position_mm().z(), 80);
  EXPECT_LT(std::fabs(harness.RpyDegrees().x()), 5);
}

TEST(OdeBodyTest, DisabledJointAsksForNoDrive) {
  OdeBody body(Ers210(), World{});
  BodyHarness harness(Ers210(), &body);
  harness.Hold(0.1);
  for (const JointState& joint : body.state().joints) EXPECT_EQ(joint.drive, 0);
}

// Random targets, also beyond the stops, and joints that are switched off and on: the body must
// stay slow and on the floor however bad a program is.
TEST(OdeBodyTest, FlailingRobotStaysOnTheFloor) {
  OdeBody body(Ers210(), World{});
  BodyHarness harness(Ers210(), &body);
  uint32_t random = 1;
  const auto next = [&random] { return (random = random * 1664525 + 1013904223) / 4294967296.0; };
  for (int i = 0; i < 50; ++i) {
    for (size_t j = 0; j < harness.commands.size(); ++j) {
      const Range& stops = Ers210().joints[j].hard_rad;
      harness.commands[j].target_rad = stops.min - 0.2 + next() * (stops.max - stops.min + 0.4);
      harness.commands[j].enabled = next() < 0.9;
    }
    harness.Hold(0.16);
    ASSERT_LT(body.state().v_WB.norm(), 3) << "move " << i;
    ASSERT_NEAR(harness.Position_mm().z(), 120, 120) << "move " << i;
  }
}

TEST(OdeBodyTest, PosesOfPartsBelongToTheMeasuredAngles) {
  OdeBody body(Ers210(), World{});
  BodyHarness harness(Ers210(), &body);
  harness.StandUp();
  std::vector<double> angles_rad;
  for (const JointState& joint : body.state().joints) angles_rad.push_back(joint.angle_rad);
  const auto X_BL = LinkPoses(Ers210(), angles_rad);
  const auto X_WL = body.BodyPoses();
  for (size_t i = 0; i < X_WL.size(); ++i) {
    EXPECT_TRUE(X_WL[i].isApprox(body.state().X_WB * X_BL[i], 1e-12)) << Ers210().bodies[i].name;
  }
}

TEST(OdeBodyTest, ModelWithoutBoxesIsRefusedByName) {
  RobotModel model = Ers210();
  model.bodies[0].has_box = false;
  EXPECT_EQ(ErrorOf([&] { OdeBody(model, World{}); }),
            "ERS-210: no ODE body: part 'body' has no box in the model file; use --body ideal");
}

TEST(OdeBodyTest, PartWithoutMassIsRefusedByName) {
  RobotModel model = Ers210();
  model.bodies[4].mass_kg = 0;
  EXPECT_EQ(ErrorOf([&] { OdeBody(model, World{}); }),
            "ERS-210: no ODE body: part 'mouth' has no mass in the model file; use --body ideal");
}

TEST(OdeBodyTest, JointWithoutTorqueIsRefusedByName) {
  RobotModel model = Ers210();
  model.joints[16].stall_torque_nm = 0;
  EXPECT_EQ(
      ErrorOf([&] { OdeBody(model, World{}); }),
      "ERS-210: no ODE body: joint 'tail_pan' has no torque in the model file; use --body ideal");
}

TEST(OdeBodyTest, Ers220StandsUp) {
  const RobotModel model = ModelNamed("ers220.json");
  OdeBody body(model, World{});
  BodyHarness harness(model, &body);
  harness.StandUp();
  EXPECT_NEAR(harness.Position_mm().z(), 137.2, 3);
  EXPECT_EQ(harness.PawsDown(), 4);
}

TEST(OdeBodyTest, Ers7StandsUpAndSits) {
  const RobotModel model = ModelNamed("ers7.json");
  OdeBody body(model, World{});
  BodyHarness harness(model, &body);
  harness.StandUp();
  EXPECT_NEAR(harness.Position_mm().z(), 145.6, 3);
  EXPECT_NEAR(harness.RpyDegrees().y(), 1.43, 1);
  EXPECT_EQ(harness.PawsDown(), 4);
  EXPECT_LT(harness.JointErrorDegrees(), 2);
  harness.RampTo(harness.Posture("sit"));
  harness.Hold(1);
  EXPECT_NEAR(harness.RpyDegrees().y(), -37.3, 1);  // as its own motions say
  EXPECT_NEAR(harness.RpyDegrees().x(), 0, 1);
}

TEST(OdeBodyTest, SeesAWallThroughItsRay) {
  World world;
  world.things.push_back({.name = "wall", .size_m = {0.1, 1, 1}, .centre_m = {0.55, 0, 0.5}});
  OdeBody body(Ers210(), world);
  EXPECT_DOUBLE_EQ(body.CastRay({0, 0, 0.1}, {1, 0, 0}, 0.9).distance_m, 0.5);
}

}  // namespace
}  // namespace openr_host
