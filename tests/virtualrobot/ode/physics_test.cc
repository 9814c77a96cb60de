// Physics that one can check by hand: what falls, loses energy and is mirrored as it must.
#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/ode/ode_body.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d CentreOfAll(const std::vector<Isometry3d>& X_WL) {
  Vector3d sum = Vector3d::Zero();
  for (size_t i = 0; i < X_WL.size(); ++i)
    sum += Ers210().bodies[i].mass_kg * (X_WL[i] * Ers210().bodies[i].centre_m);
  return sum / Ers210().TotalMassKg();
}

// Returns the kinetic and potential energy, in J, of parts that moved from `before` to `now` in one
// frame.
double EnergyIn(const std::vector<Isometry3d>& before, const std::vector<Isometry3d>& now) {
  double energy_j = 0;
  for (size_t i = 0; i < now.size(); ++i) {
    const BodyPart& part = Ers210().bodies[i];
    const Vector3d squares = part.size_m.cwiseProduct(part.size_m);
    const Vector3d inertia = part.mass_kg / 12 * (Vector3d::Constant(squares.sum()) - squares);
    const Matrix3d turn = before[i].linear().transpose() * now[i].linear();
    const Vector3d w =
        Vector3d(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1)) /
        (2 * kFrame_s);
    const Vector3d place = now[i] * part.centre_m;
    const Vector3d v = (place - before[i] * part.centre_m) / kFrame_s;
    energy_j += part.mass_kg * (v.squaredNorm() / 2 + kGravity_m_s2 * place.z()) +
                w.dot(Vector3d(inertia.cwiseProduct(w))) / 2;
  }
  return energy_j;
}

// A limp robot at rest, tilted, at a height where nothing touches.
OdeBody InTheAir(double height_m) {
  RestingPose pose;
  pose.X_WB.linear() = RotationFromRpy({0.4, 0.2, 0.3});
  pose.X_WB.translation() = Vector3d(0, 0, height_m);
  return OdeBody(Ers210(), World{}, pose, Ers210().PostureAngles("stand"));
}

TEST(PhysicsTest, LimpRobotFallsFreely) {
  OdeBody body = InTheAir(2);
  BodyHarness harness(Ers210(), &body);
  const Vector3d start = CentreOfAll(body.BodyPoses());
  constexpr int kFrames = 50;
  harness.Hold(kFrames * kFrame_s);
  const Vector3d way = CentreOfAll(body.BodyPoses()) - start;
  // A frame moves with the speed at its end, so the way is g h^2 (1 + 2 + ... + 50).
  EXPECT_NEAR(way.z(), -kGravity_m_s2 * kFrame_s * kFrame_s * kFrames * (kFrames + 1) / 2, 1e-9);
  EXPECT_LT(way.head<2>().norm(), 1e-9);
}

TEST(PhysicsTest, EnergyOfTheUnpoweredDogNeverGrows) {
  OdeBody body = InTheAir(0.4);
  BodyHarness harness(Ers210(), &body);
  std::vector<Isometry3d> before = body.BodyPoses();
  const double start_j = EnergyIn(before, before);
  double least_j = start_j, grown_j = 0;
  for (int i = 0; i < FramesIn(5); ++i) {
    harness.Frame();
    const std::vector<Isometry3d> now = body.BodyPoses();
    const double energy_j = EnergyIn(before, now);
    grown_j = std::max(grown_j, energy_j - least_j);
    least_j = std::min(least_j, energy_j);
    before = now;
  }
  // A paw that has sunk into the floor is lifted out again, which costs the floor a little.
  EXPECT_LT(grown_j, 0.01 * start_j);
  EXPECT_LT(least_j, 0.3 * start_j);  // the robot has fallen
  EXPECT_GT(least_j, 0);
}

// The joints of one side do what those of the other side do in the other robot.
TEST(PhysicsTest, MirroredCommandsMoveItLikeInAMirror) {
  OdeBody body(Ers210(), World{}), mirrored(Ers210(), World{});
  BodyHarness harness(Ers210(), &body), mirror(Ers210(), &mirrored);
  harness.StandUp();
  mirror.StandUp();
  const double start_mm = harness.Position_mm().x();
  const auto set = [](BodyHarness* harness, const std::string& side, double sign, double phase) {
    const double swing = std::sin(phase) * 0.3;
    harness->Command(side + "F_j1").target_rad += 0.02 * swing;
    harness->Command(side + "H_j3").target_rad += 0.03 * swing;
    harness->Command("neck_pan").target_rad += sign * 0.05 * swing;
    harness->Command("tail_pan").target_rad += sign * 0.03 * swing;
  };
  double sideways_mm = 0;
  for (int i = 0; i < FramesIn(2); ++i) {
    set(&harness, "L", 1, i * 0.05);
    set(&mirror, "R", -1, i * 0.05);
    harness.Frame();
    mirror.Frame();
    const Vector3d place = harness.Position_mm(), image = mirror.Position_mm();
    sideways_mm = std::max(sideways_mm, std::fabs(place.y()));
    ASSERT_NEAR(place.x(), image.x(), 0.05) << "frame " << i;
    ASSERT_NEAR(place.y(), -image.y(), 0.05) << "frame " << i;
    ASSERT_NEAR(place.z(), image.z(), 0.05) << "frame " << i;
    ASSERT_NEAR(harness.RpyDegrees().x(), -mirror.RpyDegrees().x(), 0.02) << "frame " << i;
    ASSERT_NEAR(harness.RpyDegrees().z(), -mirror.RpyDegrees().z(), 0.02) << "frame " << i;
  }
  // The robots have moved, so the comparisons above say something.
  EXPECT_GT(sideways_mm + std::fabs(harness.Position_mm().x() - start_mm), 0.5);
}

TEST(PhysicsTest, AnAbsurdPushDoesNotTearItApart) {
  for (const char* const file : {"ers210.json", "ers7.json"}) {
    const RobotModel model = ModelNamed(file);
    for (size_t part = 0; part < model.bodies.size(); ++part) {
      OdeBody body(model, World{});
      BodyHarness harness(model, &body);
      for (int i = 0; i < 20; ++i) {
        body.Push(static_cast<int>(part), {300, 1000, 200}, body.BodyPoses()[part].translation());
        harness.Frame();
      }
      harness.Hold(2);
      EXPECT_LT(body.state().v_WB.norm(), 100) << model.bodies[part].name;
      for (const JointState& joint : body.state().joints)
        EXPECT_LE(std::fabs(joint.speed_rad_s), JointTree::kTurnMax_rad_s);
    }
  }
}

TEST(PhysicsTest, HalfTheStepGivesHalfTheError) {
  // The angle of a leg that is moving, with the trunk high in the air.
  const auto angle_deg = [](int steps_per_frame) {
    RestingPose pose;
    pose.X_WB.translation() = Vector3d(0, 0, 2);
    OdeSettings settings;
    settings.steps_per_frame = steps_per_frame;
    OdeBody body(Ers210(), World{}, pose, Ers210().PostureAngles("stand"), settings);
    BodyHarness harness(Ers210(), &body);
    harness.EnableAll();
    harness.Command("neck_pan").target_rad += 0.5;
    harness.Command("LF_j1").target_rad -= 0.5;
    harness.Hold(0.08);
    return harness.AngleDegrees("LF_j1");
  };
  const double coarse = angle_deg(4) - angle_deg(8), fine = angle_deg(8) - angle_deg(16),
               finer = angle_deg(16) - angle_deg(32);
  EXPECT_GT(std::fabs(coarse), 1e-4);
  EXPECT_NEAR(coarse / fine, 2, 0.4);
  EXPECT_NEAR(fine / finer, 2, 0.3);
}

}  // namespace
}  // namespace openr_host
