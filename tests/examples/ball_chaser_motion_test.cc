// The legs of examples/BallChaser: the gait walks as it is told, and the dog gets up from anywhere.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "Leg.h"
#include "Maths.h"
#include "tests/examples/walking_dog.h"

namespace openr_host {
namespace {

TEST(BallChaserMathsTest, SinesAndArcTangentsAreThoseOfTheHost) {
  for (double x = -10; x < 10; x += 0.01) {
    EXPECT_NEAR(Sin(x), DetSin(x), 1e-7);
    EXPECT_NEAR(Cos(x), DetCos(x), 1e-7);
    EXPECT_NEAR(ArcTan2(DetSin(x), DetCos(x)), DetAtan2(DetSin(x), DetCos(x)), 1e-7);
  }
  EXPECT_EQ(ArcTan2(0, 0), 0);
}

// The paw of a body whose leg has the angles is where the angles were asked for.
TEST(BallChaserLegTest, AnglesBringThePawToItsPlace) {
  const RobotModel& model = Ers210();
  const std::array<std::string, NUM_LEGS> names = {"LF", "LH", "RF", "RH"};
  for (int leg = 0; leg < NUM_LEGS; ++leg) {
    const Paw& paw = model.paws[static_cast<size_t>(leg)];
    ASSERT_EQ(paw.leg, names[static_cast<size_t>(leg)]);
    const Place place = {IsFore(leg) ? 90.0 : -70.0, IsLeft(leg) ? 75.0 : -75.0, -85};
    std::array<double, JOINTS_PER_LEG> angles{};
    FindLegAngles(leg, place, angles.data());
    std::vector<double> joints(model.joints.size());
    for (size_t j = 0; j < angles.size(); ++j) {
      const int joint = model.FindJoint(paw.leg + "_j" + std::to_string(j + 1));
      joints[static_cast<size_t>(joint)] = angles[j];
    }
    const auto poses = LinkPoses(model, joints);
    const Eigen::Vector3d found = poses[static_cast<size_t>(paw.body)] * paw.centre_m * 1000;
    EXPECT_NEAR(found.x(), place.x, 1) << paw.leg;
    EXPECT_NEAR(found.y(), place.y, 1) << paw.leg;
    EXPECT_NEAR(found.z(), place.z, 1) << paw.leg;
  }
}

TEST(BallChaserLegTest, APlaceOutOfReachGivesAnglesWithinTheLimits) {
  std::array<double, JOINTS_PER_LEG> angles{};
  for (const Place& place : {Place{500, 0, -500}, Place{60, 59, 0}, Place{60, 400, -10}}) {
    FindLegAngles(LEFT_FORE, place, angles.data());
    EXPECT_GE(angles[1], Radians(-11.001));
    EXPECT_LE(angles[1], Radians(89.001));
    EXPECT_GE(angles[2], Radians(-27.001));
    EXPECT_LE(angles[2], Radians(147.001));
  }
}

struct Trip {
  double forward_mm_s, left_mm_s, turn_deg_s;
};

// Walks for five seconds, after one second to begin, and expects the speeds within a quarter.
void ExpectTrip(const Trip& trip) {
  SCOPED_TRACE(fmt::format("{} mm/s, {} mm/s, {} degrees/s", trip.forward_mm_s, trip.left_mm_s,
                           trip.turn_deg_s));
  WalkingDog dog;
  dog.Walk(trip.forward_mm_s, trip.left_mm_s, trip.turn_deg_s);
  dog.Run(1);
  dog.Count();
  dog.Run(5);
  const auto tolerance = [](double wanted) { return 0.25 * std::fabs(wanted) * 5 + 50; };
  EXPECT_NEAR(dog.forward_mm(), 5 * trip.forward_mm_s, tolerance(trip.forward_mm_s));
  EXPECT_NEAR(dog.left_mm(), 5 * trip.left_mm_s, tolerance(trip.left_mm_s));
  EXPECT_NEAR(dog.turn_deg(), 5 * trip.turn_deg_s, 0.15 * std::fabs(trip.turn_deg_s) * 5 + 10);
  EXPECT_LT(dog.tilt_deg_max(), 8);
}

TEST(BallChaserGaitTest, WalksForwardBackwardSidewaysAndAround) {
  ExpectTrip({200, 0, 0});
  ExpectTrip({-100, 0, 0});
  ExpectTrip({0, 100, 0});
  ExpectTrip({0, -100, 0});
  ExpectTrip({0, 0, 90});
  ExpectTrip({100, 0, -40});
}

TEST(BallChaserGaitTest, StandsStillWhenItIsToldTo) {
  WalkingDog dog;
  dog.Walk(200, 0, 0);
  dog.Run(2);
  dog.Walk(0, 0, 0);
  dog.Run(2);
  dog.Count();
  dog.Run(5);
  EXPECT_LT(std::fabs(dog.forward_mm()), 3);
  EXPECT_LT(std::fabs(dog.turn_deg()), 1);
}

TEST(BallChaserGaitTest, StaysUprightForMinutesWhateverItIsTold) {
  WalkingDog dog;
  for (int i = 0; i < 150; ++i) {
    dog.Walk(i * 97 % 440 - 220, i * 61 % 240 - 120, i * 43 % 200 - 100);
    dog.Run(0.8);
    ASSERT_TRUE(dog.motion().IsWalking()) << "after " << i;
  }
  EXPECT_LT(dog.tilt_deg_max(), 15);
}

// Turns the dog over by hand, and lets it lie for a moment.
void ThrowOver(WalkingDog* dog, double roll_deg, double pitch_deg) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = (Eigen::AngleAxisd(Radians(roll_deg), Eigen::Vector3d::UnitX()) *
                   Eigen::AngleAxisd(Radians(pitch_deg), Eigen::Vector3d::UnitY()))
                      .toRotationMatrix();
  X_WB.translation().z() = 0.25;
  dog->body().Hold(X_WB);
  dog->Run(1);
  EXPECT_GT(dog->TiltDegrees(), 45);
  dog->body().Hold(std::nullopt);
}

TEST(BallChaserMotionTest, GetsUpFromItsSidesItsBackAndItsNose) {
  const std::array<std::array<double, 2>, 6> ways = {
      {{90, 0}, {-90, 0}, {75, 20}, {-75, -20}, {170, 0}, {0, 90}}};
  for (const auto& [roll_deg, pitch_deg] : ways) {
    SCOPED_TRACE(fmt::format("roll {}, pitch {}", roll_deg, pitch_deg));
    WalkingDog dog;
    ThrowOver(&dog, roll_deg, pitch_deg);
    dog.Run(12);
    EXPECT_LT(dog.TiltDegrees(), 5);
    EXPECT_TRUE(dog.motion().IsWalking());
  }
}

TEST(BallChaserMotionTest, TheHeadTurnsAsItIsToldWithinItsLimits) {
  WalkingDog dog;
  dog.motion().SetCommand({0, 0, 0, 0.5, -0.4});
  dog.Run(2);
  const auto angle = [&](const char* joint) {
    return dog.body().state().joints[static_cast<size_t>(Ers210().FindJoint(joint))].angle_rad;
  };
  EXPECT_NEAR(angle("neck_pan"), 0.5, 0.05);
  EXPECT_NEAR(angle("neck_tilt"), -0.4, 0.06);
  dog.motion().SetCommand({0, 0, 0, 9, 9});
  dog.Run(3);
  EXPECT_NEAR(Degrees(angle("neck_pan")), 85, 4);
  EXPECT_NEAR(Degrees(angle("neck_tilt")), 40, 4);
}

}  // namespace
}  // namespace openr_host
