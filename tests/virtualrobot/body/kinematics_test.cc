#include "virtualrobot/body/kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/base/rng.h"
#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/base/rotation.h"
#include "virtualrobot/body/stiff_robot.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

struct Row {
  const char* posture;
  double pitch_deg;  // nose down positive
  double height_mm;  // height of the J1 axes over the floor
};

// Results of forward kinematics that were computed without this code (robot data, section 11).  The
// attitudes of sitting and crouching agree with those in the vendor's motion files.
TEST(KinematicsTest, Ers210RestsAsTheTableSays) {
  for (const Row& row :
       {Row{"stand", 2.6, 137.2}, Row{"stand_tekkotsu", 2.6, 136.1}, Row{"sit", -28.0, 86.2},
        Row{"sleep", 4.2, 57.8}, Row{"crouch", -4.2, 85.0}, Row{"crouch_low", -4.5, 69.5}}) {
    SCOPED_TRACE(row.posture);
    const RestingPose pose = PlaceOnFloor(Ers210(), Ers210().PostureAngles(row.posture));
    EXPECT_NEAR(Degrees(RpyOf(pose.X_WB.linear()).y()), row.pitch_deg, 0.06);
    EXPECT_NEAR(pose.X_WB.translation().z() * 1000, row.height_mm, 0.06);
    EXPECT_EQ(pose.paws, std::vector<bool>(4, true));
  }
}

TEST(KinematicsTest, BroadbaseLiesOnItsBellyWithThePawsOff) {
  const RestingPose pose = PlaceOnFloor(Ers210(), Ers210().PostureAngles("broadbase"));
  EXPECT_NEAR(pose.X_WB.translation().z() * 1000, 50 - 3.9, 1e-9);  // lower face of the trunk
  EXPECT_EQ(pose.paws, std::vector<bool>(4, false));
}

TEST(KinematicsTest, ARobotWithoutMassesStandsOnItsPaws) {
  RobotModel model = Ers210();
  for (BodyPart& part : model.bodies) part.mass_kg = 0;
  const RestingPose pose = PlaceOnFloor(model, model.PostureAngles("stand"));
  EXPECT_NEAR(Degrees(RpyOf(pose.X_WB.linear()).y()), 2.6, 0.1);
  EXPECT_NEAR(pose.X_WB.translation().z() * 1000, 137.2, 0.5);
  EXPECT_EQ(pose.paws, std::vector<bool>(4, true));
}

TEST(KinematicsTest, NothingIsBelowTheFloorInAnyPosture) {
  for (const char* file : {"ers210.json", "ers220.json"}) {
    const RobotModel model = ModelNamed(file);
    for (const Posture& posture : model.postures) {
      SCOPED_TRACE(posture.name);
      const RestingPose pose = PlaceOnFloor(model, posture.angles_rad);
      EXPECT_NEAR(LowestPoint(model, posture.angles_rad, pose.X_WB), 0, 1e-9);
    }
  }
}

TEST(KinematicsTest, SittingErs7LeansAsItsMotionsSay) {
  const RobotModel model = ModelNamed("ers7.json");
  const RestingPose pose = PlaceOnFloor(model, model.PostureAngles("sit"));
  EXPECT_NEAR(Degrees(RpyOf(pose.X_WB.linear()).y()), -37.3, 0.05);
}

// Printed in the drawing with all J3 at 35 degrees: 64 + 64.9 and 64 + 74.9 below the J1 axes.
TEST(KinematicsTest, PawsReachTheDrawnDepthsAtKnee35) {
  std::vector<double> angles_rad(Ers210().joints.size(), 0.0);
  for (const char* leg : {"LF", "LH", "RF", "RH"}) {
    angles_rad[Ers210().FindJoint(std::string(leg) + "_j3")] = Radians(35);
  }
  const auto X_BL = LinkPoses(Ers210(), angles_rad);
  for (const Paw& paw : Ers210().paws) {
    const Vector3d centre_B = X_BL[paw.body] * paw.centre_m;
    EXPECT_NEAR((centre_B.z() - paw.radius_m) * 1000, paw.leg[1] == 'F' ? -128.9 : -138.9, 0.05);
  }
}

TEST(KinematicsTest, ZeroAnglesLeaveEveryLinkFrameOnTheBaseFrame) {
  for (const auto& X_BL : LinkPoses(Ers210(), std::vector<double>(18, 0.0))) {
    EXPECT_TRUE(X_BL.isApprox(Eigen::Isometry3d::Identity(), 1e-15));
  }
}

TEST(KinematicsTest, PositiveValuesMoveAsTheModelInformationDraws) {
  struct Case {
    const char* joint;
    const char* body;
    Vector3d tip_m;  // a point of the body, at zero angles
    Vector3d moves;  // direction in which the point moves
  };
  for (const Case& c : {Case{"neck_tilt", "head", {0.15, 0, 0.1}, {0, 0, 1}},    // nose up
                        Case{"neck_pan", "head", {0.15, 0, 0.1}, {0, 1, 0}},     // to the left
                        Case{"neck_roll", "head", {0.1, 0, 0.14}, {0, -1, 0}},   // top to the right
                        Case{"LF_j1", "LF_j3", {0.06, 0.06, -0.12}, {1, 0, 0}},  // foot forward
                        Case{"RH_j1", "RH_j3", {-0.05, -0.06, -0.12}, {-1, 0, 0}},  // foot rearward
                        Case{"LF_j2", "LF_j3", {0.06, 0.06, -0.12}, {0, 1, 0}},     // leg out
                        Case{"RF_j2", "RF_j3", {0.06, -0.06, -0.12}, {0, -1, 0}},
                        Case{"tail_tilt", "tail_tilt", {-0.14, 0, 0.06}, {0, 0, 1}},  // tip up
                        Case{"tail_pan", "tail_tilt", {-0.14, 0, 0.06}, {0, -1, 0}}}) {
    SCOPED_TRACE(c.joint);
    std::vector<double> angles_rad(18, 0.0);
    angles_rad[Ers210().FindJoint(c.joint)] = 0.01;
    const auto X_BL = LinkPoses(Ers210(), angles_rad);
    const Vector3d moved = X_BL[Ers210().FindBody(c.body)] * c.tip_m - c.tip_m;
    EXPECT_GT(moved.dot(c.moves), 0.9 * moved.norm() * 0.5);
    EXPECT_GT(moved.norm(), 1e-4);
  }
}

TEST(KinematicsTest, CentreOfMassAtZeroIsTheTablesWithTheOdeMasses) {
  EXPECT_TRUE((StiffRobot(Ers210()).CentreOfMass() * 1000).isApprox(Vector3d(11.2, 0, -3.1), 0.01));
}

// Turns some joints at a time, so that most parts keep the poses of the step before.
TEST(StiffRobotTest, HasTheBitsOfARobotMadeAnewWhateverMovedBefore) {
  const RobotModel& model = Ers210();
  std::vector<double> angles_rad = model.PostureAngles("stand");
  StiffRobot kept(model, angles_rad);
  Rng random(7, "angles");
  for (int step = 0; step < 300; ++step) {
    const auto joint = static_cast<size_t>(random.NextDouble() * 18);
    const Range& range = model.joints[joint].hard_rad;
    angles_rad[joint] = range.min + random.NextDouble() * (range.max - range.min);
    kept.SetAngle(joint, angles_rad[joint]);
    if (step % 3 == 0) continue;  // so the next Move() turns two joints
    kept.Move();
    const StiffRobot anew(model, angles_rad);
    RestingPose pose_kept, pose_anew;
    kept.PlaceOnFloor(&pose_kept);
    anew.PlaceOnFloor(&pose_anew);
    for (size_t i = 0; i < model.bodies.size(); ++i)
      ASSERT_EQ(kept.X_BL()[i].matrix(), anew.X_BL()[i].matrix()) << step << " " << i;
    ASSERT_EQ(pose_kept.X_WB.matrix(), pose_anew.X_WB.matrix()) << step;
    ASSERT_EQ(pose_kept.paws, pose_anew.paws) << step;
  }
}

// Boxes that are far above the lowest point are left out of the search; none may be missed.
TEST(HullTest, TheLowestPointIsTheLowestOfAllCornersAndBalls) {
  const RobotModel& model = Ers210();
  const StiffRobot robot(model, model.PostureAngles("sit"));
  Rng random(11, "turns");
  for (int turn = 0; turn < 200; ++turn) {
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
    X_WB.linear() = RotationFromRpy(
        {6 * random.NextDouble(), 3 * random.NextDouble() - 1.5, 6 * random.NextDouble()});
    double lowest_m = 1e9;
    for (size_t i = 0; i < model.bodies.size(); ++i) {
      const BodyPart& part = model.bodies[i];
      for (int corner = 0; part.has_box && corner < 8; ++corner) {
        const Vector3d side(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5,
                            corner & 4 ? 0.5 : -0.5);
        const Vector3d p = part.centre_m + part.size_m.cwiseProduct(side);
        lowest_m = std::min(lowest_m, (X_WB * (robot.X_BL()[i] * p)).z());
      }
    }
    for (const Paw& paw : model.paws) {
      const Vector3d p = X_WB * (robot.X_BL()[static_cast<size_t>(paw.body)] * paw.centre_m);
      lowest_m = std::min(lowest_m, p.z() - paw.radius_m);
    }
    EXPECT_NEAR(robot.LowestPoint(X_WB), lowest_m, 1e-12) << turn;
  }
}

TEST(KinematicsTest, RollPitchYawComeBack) {
  const Vector3d rpy_rad(0.3, -0.7, 2.5);
  EXPECT_TRUE(RpyOf(RotationFromRpy(rpy_rad)).isApprox(rpy_rad, 1e-14));
}

TEST(KinematicsTest, NoseDownIsPositivePitch) {
  const Vector3d nose_W = RotationFromRpy({0, 0.1, 0}) * Vector3d::UnitX();
  EXPECT_LT(nose_W.z(), 0);
}

}  // namespace
}  // namespace openr_host
