#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/ode/ode_body.h"

namespace openr_host {
namespace {

uint64_t HashAfterStandingUp() {
  OdeBody body(Ers210(), World{});
  BodyHarness harness(Ers210(), &body);
  harness.Hold(0.5);
  harness.StandUp();
  return StateHash(body);
}

// The bits of the body with Debian 12's ODE 0.16.2 on x86-64: equal for g++ and clang++, any
// optimisation, with and without FMA.  Change it only in a commit that says what moved, and why.
constexpr uint64_t kStandUpGolden = 0xb32cbbec47e6f3bf;

TEST(OdeDeterminismTest, StandingUpEndsInTheGoldenState) {
  EXPECT_EQ(HashAfterStandingUp(), kStandUpGolden);
}

TEST(OdeDeterminismTest, AnotherWorldInTheSameProcessDoesNotShow) {
  OdeBody alone(Ers210(), World{});
  BodyHarness alone_harness(Ers210(), &alone);
  alone_harness.EnableAll();
  alone_harness.RampTo(alone_harness.Posture("broadbase"));

  OdeBody one(Ers210(), World{}), other(Ers210(), World{});
  BodyHarness one_harness(Ers210(), &one), other_harness(Ers210(), &other);
  other_harness.EnableAll();
  one_harness.EnableAll();
  // Frame by frame in turn with a robot that does something else.
  class Interleaved : public Body {
   public:
    Interleaved(Body* body, BodyHarness* company) : body_(*body), company_(*company) {}
    using Body::Advance;
    void Advance() override {}
    void SetCommands(const std::vector<JointCommand>& commands) override {
      company_.Command("neck_pan").target_rad += 0.01;
      company_.Frame();
      body_.Advance(commands);
    }
    const BodyState& state() const override { return body_.state(); }
    RayHit CastRay(const Eigen::Vector3d&, const Eigen::Vector3d&, double max_m) const override {
      return {.distance_m = max_m};
    }
    const World& world() const override { return body_.world(); }
    std::vector<Eigen::Isometry3d> BodyPoses() const override { return body_.BodyPoses(); }
    void HashState(Hasher* hasher) const override { body_.HashState(hasher); }

   private:
    Body& body_;
    BodyHarness& company_;
  } interleaved(&one, &other_harness);
  BodyHarness harness(Ers210(), &interleaved);
  harness.EnableAll();
  harness.RampTo(harness.Posture("broadbase"));
  EXPECT_EQ(StateHash(one), StateHash(alone));
}

TEST(OdeDeterminismTest, EveryFrameOfTwoRunsIsEqual) {
  OdeBody a(Ers210(), World{}), b(Ers210(), World{});
  BodyHarness harness_a(Ers210(), &a), harness_b(Ers210(), &b);
  for (int i = 0; i < 200; ++i) {
    harness_a.Frame();
    harness_b.Frame();
    ASSERT_EQ(StateHash(a), StateHash(b)) << "frame " << i;
  }
}

TEST(OdeDeterminismTest, HashSeesASetPointThatHasNotMovedAnythingYet) {
  OdeBody a(Ers210(), World{}), b(Ers210(), World{});
  BodyHarness harness_a(Ers210(), &a), harness_b(Ers210(), &b);
  harness_a.EnableAll();
  harness_b.EnableAll();
  harness_b.Command("neck_pan").target_rad += 1e-9;
  harness_a.Frame();
  harness_b.Frame();
  EXPECT_NE(StateHash(a), StateHash(b));
}

TEST(OdeDeterminismTest, HashSeesAPushThatIsStillToCome) {
  OdeBody a(Ers210(), World{}), b(Ers210(), World{});
  b.Push(0, {0, 0, 1}, {0, 0, 0});
  EXPECT_NE(StateHash(a), StateHash(b));
}

}  // namespace
}  // namespace openr_host
