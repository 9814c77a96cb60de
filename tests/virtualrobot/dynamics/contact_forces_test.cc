// The law of contacts: what sticks, slides or opens does so as Coulomb says.
#include "virtualrobot/dynamics/contact_forces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace openr_host {
namespace {

constexpr double kFriction = 0.5;

// A contact of a mass of 1 kg with the softness `soft`.
ContactEquations OneMass(double soft, double press, double x, double y) {
  ContactEquations equations;
  equations.Reset(1);
  for (int i = 0; i < 3; ++i) equations.At(i, i) = 1 + soft;
  equations.wanted = {press, x, y};
  return equations;
}

TEST(ContactForcesTest, StickingMassIsStopped) {
  ContactForces forces(kFriction);
  const std::vector<double>& p = forces.Find(OneMass(0, 2, 0.6, -0.8));
  EXPECT_DOUBLE_EQ(p[0], 2);
  EXPECT_DOUBLE_EQ(p[1], 0.6);
  EXPECT_DOUBLE_EQ(p[2], -0.8);
  EXPECT_EQ(forces.sweeps(), 0);
}

TEST(ContactForcesTest, SoftnessYields) {
  ContactForces forces(kFriction);
  EXPECT_DOUBLE_EQ(forces.Find(OneMass(0.25, 2, 0, 0))[0], 2 / 1.25);
}

TEST(ContactForcesTest, SlidingMassIsSlowedByTheCoefficientTimesThePressure) {
  ContactForces forces(kFriction);
  const std::vector<double>& p = forces.Find(OneMass(0, 2, -3, 4));
  EXPECT_DOUBLE_EQ(p[0], 2);
  EXPECT_NEAR(p[1], -0.6, 1e-5);  // 1 N s, against the velocity (3, -4)
  EXPECT_NEAR(p[2], 0.8, 1e-5);
}

TEST(ContactForcesTest, MassThatLeavesIsNotHeldBack) {
  ContactForces forces(kFriction);
  EXPECT_EQ(forces.Find(OneMass(0, -1, 3, 4)), std::vector<double>(3, 0));
}

TEST(ContactForcesTest, NothingTouches) {
  ContactEquations equations;
  equations.Reset(0);
  EXPECT_TRUE(ContactForces(kFriction).Find(equations).empty());
}

// Equations of up to eight contacts of a body with twelve unknowns, so that contacts share their
// load in many ways.
class RandomContacts {
 public:
  double Next() { return (random_ = random_ * 1664525 + 1013904223) / 2147483648.0 - 1; }

  ContactEquations Make() {
    const int contacts = 1 + static_cast<int>((Next() + 1) * 4);
    ContactEquations equations;
    equations.Reset(contacts);
    std::vector<double> jacobian(12 * equations.rows());
    for (double& value : jacobian) value = 2 * Next();
    for (int a = 0; a < equations.rows(); ++a) {
      for (int b = 0; b < equations.rows(); ++b) {
        for (int i = 0; i < 12; ++i)
          equations.At(a, b) += jacobian[12 * a + i] * jacobian[12 * b + i];
      }
      equations.At(a, a) += 0.25;
      equations.wanted[a] = Next() + (a % 3 == 0 ? 0.5 : 0);
    }
    return equations;
  }

 private:
  uint32_t random_ = 1;
};

TEST(ContactForcesTest, EveryContactObeysTheLaw) {
  ContactForces forces(kFriction);
  RandomContacts random;
  int sticking = 0, sliding = 0, open = 0;
  for (int round = 0; round < 2000; ++round) {
    const ContactEquations equations = random.Make();
    const std::vector<double>& p = forces.Find(equations);
    if (forces.sweeps() == ContactForces::kSweepsMax) continue;  // counted by the next test
    for (int c = 0; c < equations.contacts(); ++c) {
      double missing[3];
      for (int k = 0; k < 3; ++k) {
        missing[k] = equations.wanted[3 * c + k];
        for (int i = 0; i < equations.rows(); ++i) missing[k] -= equations.Row(3 * c + k)[i] * p[i];
      }
      const double along = std::hypot(p[3 * c + 1], p[3 * c + 2]);
      const double limit = kFriction * p[3 * c];
      constexpr double kClose = 1e-3;  // m/s; a change of 1e-6 N s moves the velocity by up to 1e-4
      ASSERT_GE(p[3 * c], 0);
      ASSERT_LE(along, limit + 1e-9);
      if (p[3 * c] == 0) {
        ASSERT_LE(missing[0], kClose) << "round " << round;
        ++open;
        continue;
      }
      ASSERT_NEAR(missing[0], 0, kClose) << "round " << round;
      if (along < limit - 1e-5) {
        ASSERT_NEAR(std::hypot(missing[1], missing[2]), 0, kClose) << "round " << round;
        ++sticking;
      } else if (along > 1e-3) {
        // The force has the direction of the velocity that is missing.
        const double across = p[3 * c + 1] * missing[2] - p[3 * c + 2] * missing[1];
        ASSERT_NEAR(across / along, 0, kClose) << "round " << round;
        ASSERT_GT(p[3 * c + 1] * missing[1] + p[3 * c + 2] * missing[2], -kClose * along);
        ++sliding;
      }
    }
  }
  EXPECT_GT(sticking, 200);
  EXPECT_GT(sliding, 200);
  EXPECT_GT(open, 200);
}

TEST(ContactForcesTest, SweepsSettleInNearlyAllCases) {
  ContactForces forces(kFriction);
  RandomContacts random;
  int settled = 0;
  for (int round = 0; round < 2000; ++round) {
    forces.Find(random.Make());
    if (forces.sweeps() < ContactForces::kSweepsMax) ++settled;
  }
  EXPECT_GT(settled, 1900);
}

}  // namespace
}  // namespace openr_host
