#include "virtualrobot/body/ideal_body.h"

#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"

namespace openr_host {
namespace {

class IdealBodyTest : public testing::Test {
 protected:
  IdealBody body_{Ers210(), World{}};
  BodyHarness harness_{Ers210(), &body_};
};

TEST_F(IdealBodyTest, StartsAsleepOnTheFloor) {
  EXPECT_EQ(harness_.AngleDegrees("LH_j3"), 147);
  EXPECT_NEAR(harness_.Position_mm().z(), 57.8, 0.1);
  EXPECT_EQ(harness_.PawsDown(), 4);
}

TEST_F(IdealBodyTest, EnabledJointIsAtItsSetPointAtTheEndOfTheFrame) {
  harness_.EnableAll();
  harness_.Command("neck_pan").target_rad = 0.5;
  harness_.Frame();
  EXPECT_EQ(body_.state().joints[1].angle_rad, 0.5);
  EXPECT_EQ(body_.state().joints[1].speed_rad_s, 0.5 / kFrame_s);
}

TEST_F(IdealBodyTest, DisabledJointHoldsItsPosition) {
  harness_.Command("neck_pan").target_rad = 0.5;
  harness_.Hold(1);
  EXPECT_EQ(body_.state().joints[1].angle_rad, 0);
}

TEST_F(IdealBodyTest, MechanicalStopEndsAMovement) {
  harness_.EnableAll();
  harness_.Command("neck_pan").target_rad = 3;
  harness_.Frame();
  EXPECT_EQ(harness_.AngleDegrees("neck_pan"), 92.6);
}

TEST_F(IdealBodyTest, StandsAsKinematicsSay) {
  harness_.StandUp();
  EXPECT_NEAR(harness_.RpyDegrees().y(), 2.6, 0.05);
  EXPECT_NEAR(harness_.Position_mm().z(), 137.2, 0.05);
  EXPECT_EQ(harness_.PawsDown(), 4);
}

TEST_F(IdealBodyTest, LiftedPawIsOff) {
  harness_.StandUp();
  harness_.Command("RF_j3").target_rad = Radians(80);
  harness_.Frame();
  EXPECT_FALSE(body_.state().paws[2]);
}

TEST_F(IdealBodyTest, GravityFollowsTheAttitude) {
  harness_.EnableAll();
  harness_.RampTo(harness_.Posture("sit"));  // nose up: gravity has a part towards the tail
  EXPECT_NEAR(body_.state().gravity_B.x(), -kGravity_m_s2 * std::sin(Radians(28.03)), 0.01);
  EXPECT_NEAR(body_.state().gravity_B.norm(), kGravity_m_s2, 1e-12);
}

TEST_F(IdealBodyTest, PosesOfPartsPutThePawsOnTheFloor) {
  harness_.StandUp();
  const auto X_WL = body_.BodyPoses();
  for (const Paw& paw : Ers210().paws) {
    EXPECT_NEAR((X_WL[paw.body] * paw.centre_m).z(), paw.radius_m, 1e-9);
  }
}

TEST_F(IdealBodyTest, HashChangesWithAJointAndOnlyThen) {
  const uint64_t before = StateHash(body_);
  harness_.Hold(1);
  EXPECT_EQ(StateHash(body_), before);
  harness_.EnableAll();
  harness_.Command("mouth").target_rad = Radians(-20);
  harness_.Frame();
  EXPECT_NE(StateHash(body_), before);
}

TEST(IdealBodyModelsTest, Ers7HasAnIdealBody) {
  const RobotModel model = ModelNamed("ers7.json");
  IdealBody body(model, World{});
  BodyHarness harness(model, &body);
  harness.EnableAll();
  harness.RampTo(harness.Posture("stand"));
  EXPECT_EQ(harness.PawsDown(), 4);
}

}  // namespace
}  // namespace openr_host
