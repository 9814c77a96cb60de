// The motion of the body beside the motion that ODE's own hinges and exact solver give.
#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/ode/ode_body.h"
#include "virtualrobot/ode/ode_reference.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// A robot high above the floor, so that nothing touches, bent in all joints.
std::vector<double> BentAngles() {
  std::vector<double> angles_rad = Ers210().PostureAngles("crouch");
  for (size_t j = 0; j < angles_rad.size(); ++j) {
    const Range& stops = Ers210().joints[j].hard_rad;
    angles_rad[j] = std::clamp(angles_rad[j] + 0.1, stops.min + 0.05, stops.max - 0.05);
  }
  return angles_rad;
}

// From rest, both solvers have the same equation of motion, since no velocity bends the paths of
// the parts.  What is left is the softness of ODE's hinges, and that ODE measures speeds about the
// axes at the end of the step.
TEST(OdeReferenceTest, OneStepInTheAirIsEqual) {
  const std::vector<double> angles_rad = BentAngles();
  Isometry3d X_WB = Isometry3d::Identity();
  X_WB.linear() = RotationFromRpy({0.3, -0.2, 0.5});
  X_WB.translation() = Vector3d(0.1, 0.2, 1);
  OdeReference reference(Ers210(), World{}, X_WB, angles_rad);
  OdeBody body(Ers210(), World{}, {.X_WB = X_WB, .paws = {}}, angles_rad);
  BodyHarness harness(Ers210(), &body);
  harness.EnableAll();
  for (size_t j = 0; j < harness.commands.size(); ++j)
    harness.commands[j].target_rad += j % 2 == 0 ? 0.02 : -0.03;
  const int head = Ers210().FindBody("head");
  const Vector3d p_W = body.BodyPoses()[head] * Ers210().bodies[head].centre_m;
  body.Push(head, {0.1, 0.2, 0.3}, p_W);
  reference.Push(head, {0.1, 0.2, 0.3}, p_W);
  harness.Frame();
  reference.Advance(harness.commands);
  for (size_t j = 0; j < harness.commands.size(); ++j) {
    const double speed = body.state().joints[j].speed_rad_s;
    EXPECT_NEAR(reference.speed_rad_s(static_cast<int>(j)), speed, 1e-4 + 3e-4 * std::fabs(speed))
        << Ers210().joints[j].name;
  }
  EXPECT_LT((reference.w_W(0) - body.state().w_WB).norm(), 1e-4);
  const Vector3d centre_W = body.BodyPoses()[0].linear() * Ers210().bodies[0].centre_m;
  EXPECT_LT((reference.v_W(0) - body.state().v_WB - body.state().w_WB.cross(centre_W)).norm(),
            1e-5);
}

// Both stand up, each with its own contacts, and end in the same place.
TEST(OdeReferenceTest, StandsLikeTheBody) {
  const std::vector<double>& sleep_rad = Ers210().PostureAngles("sleep");
  OdeBody body(Ers210(), World{});
  OdeReference reference(Ers210(), World{}, PlaceOnFloor(Ers210(), sleep_rad).X_WB, sleep_rad);
  // The commands of the body's harness go to both.
  class Both : public Body {
   public:
    Both(Body* body, OdeReference* reference) : body_(*body), reference_(*reference) {}
    using Body::Advance;
    void Advance() override {}
    void SetCommands(const std::vector<JointCommand>& commands) override {
      body_.Advance(commands);
      reference_.Advance(commands);
    }
    const BodyState& state() const override { return body_.state(); }
    RayHit CastRay(const Vector3d&, const Vector3d&, double max_m) const override {
      return {.distance_m = max_m};
    }
    const World& world() const override { return body_.world(); }
    std::vector<Isometry3d> BodyPoses() const override { return body_.BodyPoses(); }
    void HashState(Hasher* hasher) const override { body_.HashState(hasher); }

   private:
    Body& body_;
    OdeReference& reference_;
  } both(&body, &reference);
  BodyHarness harness(Ers210(), &both);
  harness.StandUp();
  harness.Hold(20);  // until the paws have crept to where they press evenly
  for (size_t j = 0; j < harness.commands.size(); ++j) {
    EXPECT_NEAR(Degrees(reference.angle_rad(static_cast<int>(j))),
                Degrees(body.state().joints[j].angle_rad), 0.1)
        << Ers210().joints[j].name;
  }
  const Isometry3d X_WL = body.BodyPoses()[0];
  const Vector3d centre_W = X_WL * Ers210().bodies[0].centre_m;
  EXPECT_NEAR(reference.centre_W(0).z(), centre_W.z(), 0.0002);
  EXPECT_NEAR(reference.centre_W(0).x(), centre_W.x(), 0.005);
}

}  // namespace
}  // namespace openr_host
