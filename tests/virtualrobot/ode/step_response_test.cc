// Steps of the set point, with joints that hang free of the floor.
#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/ode/ode_body.h"

namespace openr_host {
namespace {

struct Step {
  const char* joint;
  double degrees;
};

struct Response {
  double rise_s = -1;      // first time within a tenth of the set point
  double overshoot = 0;    // share of the step
  double final_share = 0;  // where it ends, 1 is the set point
  int turns = 0;           // how often the speed changed its sign after the rise
};

// The robot lies on its belly with the legs spread out flat, so that fore legs swing free.
Response ResponseTo(const Step& step) {
  OdeBody body(Ers210(), World{});
  BodyHarness harness(Ers210(), &body);
  harness.EnableAll();
  std::vector<double> flat_rad = harness.Posture("broadbase");
  flat_rad[Ers210().FindJoint("neck_tilt")] = 0;
  harness.RampTo(flat_rad);
  harness.Hold(1);
  const int j = Ers210().FindJoint(step.joint);
  const double from_rad = body.state().joints[j].angle_rad;
  harness.commands[j].target_rad += Radians(step.degrees);
  const double step_rad = harness.commands[j].target_rad - from_rad;
  Response response;
  double last_speed = 0;
  for (int i = 1; i <= FramesIn(1.0); ++i) {
    harness.Frame();
    const JointState& joint = body.state().joints[j];
    const double share = (joint.angle_rad - from_rad) / step_rad;
    if (share > 0.9 && response.rise_s < 0) response.rise_s = i * kFrame_s;
    response.overshoot = std::max(response.overshoot, share - 1);
    response.final_share = share;
    const bool moves = std::fabs(joint.speed_rad_s) > Radians(1);
    if (response.rise_s >= 0 && moves && joint.speed_rad_s * last_speed < 0) response.turns += 1;
    if (moves) last_speed = joint.speed_rad_s;
  }
  return response;
}

class StepResponseTest : public testing::TestWithParam<Step> {};

TEST_P(StepResponseTest, RisesFastSettlesNearAndDoesNotChatter) {
  const Response response = ResponseTo(GetParam());
  EXPECT_GT(response.rise_s, 0.02);  // no faster than the motor
  EXPECT_LT(response.rise_s, 0.25);
  EXPECT_LT(response.overshoot, 0.1);
  EXPECT_NEAR(response.final_share, 1, 0.1);
  EXPECT_LE(response.turns, 1);
}

INSTANTIATE_TEST_SUITE_P(Joints, StepResponseTest,
                         testing::Values(Step{"neck_pan", 30}, Step{"neck_roll", 20},
                                         Step{"neck_tilt", 30}, Step{"mouth", -40},
                                         Step{"LF_j1", -30}, Step{"LF_j2", -10}, Step{"LF_j3", 40},
                                         Step{"RF_j3", 5}, Step{"tail_pan", 20},
                                         Step{"tail_tilt", 15}),
                         [](const auto& tested) {
                           return std::string(tested.param.joint) + "By" +
                                  std::to_string(std::abs(static_cast<int>(tested.param.degrees)));
                         });

TEST(StopTest, JointDrivenIntoItsStopIsHeldWithinADegree) {
  OdeBody body(Ers210(), World{});
  BodyHarness harness(Ers210(), &body);
  harness.EnableAll();
  harness.Command("neck_pan").target_rad = Radians(150);
  harness.Hold(2);
  EXPECT_NEAR(harness.AngleDegrees("neck_pan"), 92.6, 1);
  EXPECT_GT(body.state().joints[1].drive, kDriveFull);
}

}  // namespace
}  // namespace openr_host
