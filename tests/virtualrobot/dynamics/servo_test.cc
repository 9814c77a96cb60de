#include "virtualrobot/dynamics/servo.h"

#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"

namespace openr_host {
namespace {

constexpr double kStep_s = 0.008;

const JointModel& Joint(const char* name) { return Ers210().joints[Ers210().FindJoint(name)]; }

class ServoTest : public testing::Test {
 protected:
  JointCommand At(double target_rad) const {
    return {.target_rad = target_rad, .enabled = true, .gains = joint_.gains};
  }
  const JointModel& joint_ = Joint("LF_j1");
  Servo servo_{joint_, ServoSettings{}};
};

// J1: 240 degrees over 1023 counts is 4.2625 counts per degree; P 0x16 with shift 0x0E is
// 22 / 4 = 5.5 PWM counts per count; I adds 4 / 2^14 per count and frame.
TEST_F(ServoTest, DriveOfOneDegreeIsGainTimesCounts) {
  servo_.BeginFrame(At(0), 0);
  servo_.BeginFrame(At(0), Radians(-1));
  const double counts = 1023.0 / 240;
  EXPECT_NEAR(servo_.Drive(Radians(-1), 0), counts * (5.5 + 4 / 16384.0), 1e-9);
}

TEST_F(ServoTest, GainAndShiftTradeAsTheVendorSays) {  // P = 22 with 14 equals 11 with 15 (BBS 257)
  Servo other(joint_, ServoSettings{});
  JointCommand halved = At(0.1);
  halved.gains.p = 11;
  halved.gains.p_shift = 15;
  servo_.BeginFrame(At(0.1), 0);
  other.BeginFrame(halved, 0);
  EXPECT_DOUBLE_EQ(servo_.Drive(0, 0), other.Drive(0, 0));
}

// field-notes.md, 7.13: P = 22 with shift 16 equals 88 with 14.
TEST_F(ServoTest, AShiftOf16DoesNotDisableTheJoint) {
  Servo other(joint_, ServoSettings{});
  JointCommand whole = At(0.1), large = At(0.1);
  whole.gains.p_shift = 16;
  large.gains.p = 88;
  servo_.BeginFrame(whole, 0);
  other.BeginFrame(large, 0);
  EXPECT_DOUBLE_EQ(servo_.Drive(0, 0), other.Drive(0, 0));
  EXPECT_GT(servo_.Drive(0, 0), 0);
}

TEST_F(ServoTest, EachStepOfAShiftAbove16DoublesTheGainUpTo32) {
  const auto drive = [this](uint16_t gain, uint16_t shift) {
    Servo servo(joint_, ServoSettings{});
    JointCommand command = At(0.1);
    command.gains = {.p = gain, .p_shift = shift};
    servo.BeginFrame(command, 0);
    return servo.Drive(0, 0);
  };
  EXPECT_DOUBLE_EQ(drive(22, 18), drive(88, 16));
  EXPECT_EQ(drive(22, 40), drive(22, 32));
}

TEST_F(ServoTest, AJammedJointIsPulledToItsPlace) {
  const double angle_rad = 0.002;
  JointDisturbance disturbance;
  JointCommand command = At(angle_rad);
  servo_.BeginFrame(command, angle_rad);
  const double free_nm = servo_.Step(angle_rad, 0, kStep_s).zero_speed_nm;
  command.disturbance = &disturbance;
  servo_.BeginFrame(command, angle_rad);
  EXPECT_EQ(servo_.Step(angle_rad, 0, kStep_s).zero_speed_nm, free_nm);
  disturbance.jammed_rad = 0.003;
  EXPECT_NEAR(servo_.Step(angle_rad, 0, kStep_s).zero_speed_nm - free_nm,
              ServoSettings{}.jam_stiffness_per_rad * joint_.stall_torque_nm * 0.001, 1e-12);
}

// Else a light joint in a firm hand would swing about the hand's place and never rest there.
TEST_F(ServoTest, AHandPullsByTheAngleAtTheEndOfTheStep) {
  const ServoSettings settings;
  JointDisturbance disturbance;
  JointCommand command;
  command.disturbance = &disturbance;
  servo_.BeginFrame(command, 0);
  const TorqueLine limp = servo_.Step(0, 0, kStep_s);
  disturbance.hand_rad = 0.001;
  const TorqueLine held = servo_.Step(0, 0, kStep_s);
  EXPECT_NEAR(held.zero_speed_nm - limp.zero_speed_nm, settings.hand_stiffness_nm_per_rad * 0.001,
              1e-12);
  EXPECT_NEAR(held.slope_nm_s - limp.slope_nm_s, settings.hand_stiffness_nm_per_rad * kStep_s,
              1e-12);
}

TEST_F(ServoTest, DriveIsReportedBeyondItsClampButTheMotorGetsNoMore) {
  servo_.BeginFrame(At(Radians(90)), 0);
  EXPECT_GT(servo_.Drive(0, 0), 4 * kDriveFull);
  EXPECT_DOUBLE_EQ(servo_.Step(0, 0, kStep_s).zero_speed_nm, joint_.stall_torque_nm);
}

TEST_F(ServoTest, FullDriveGivesNoTorqueAtNoLoadSpeed) {
  servo_.BeginFrame(At(Radians(90)), 0);
  const TorqueLine line = servo_.Step(0, 0, kStep_s);
  EXPECT_NEAR(line.zero_speed_nm / line.slope_nm_s,
              ServoSettings{}.no_load_speed_ratio * joint_.speed_rad_s.max, 1e-12);
}

TEST_F(ServoTest, TorqueIsOddInTheError) {
  Servo other(joint_, ServoSettings{});
  servo_.BeginFrame(At(0.05), 0);
  other.BeginFrame(At(-0.05), 0);
  EXPECT_EQ(servo_.Step(0, 0, kStep_s).zero_speed_nm, -other.Step(0, 0, kStep_s).zero_speed_nm);
}

TEST_F(ServoTest, IntegralGrowsWithTimeAndIsBounded) {
  for (int i = 0; i < 1'000'000; ++i) servo_.BeginFrame(At(1), 0);
  const double proportional = 5.5 * Degrees(1) * 1023 / 240;
  EXPECT_NEAR(servo_.Drive(0, 0), proportional + kDriveFull, 1e-6);
}

TEST_F(ServoTest, DisabledJointAsksForNothingAndForgetsItsIntegral) {
  for (int i = 0; i < 1000; ++i) servo_.BeginFrame(At(1), 0);
  servo_.BeginFrame({}, 0);
  EXPECT_EQ(servo_.Drive(0, 0), 0);
  EXPECT_EQ(servo_.Step(0, 0, kStep_s).zero_speed_nm, 0);
  servo_.BeginFrame(At(0), 0);
  EXPECT_EQ(servo_.Drive(0, 0), 0);
}

TEST_F(ServoTest, WakingUpFarFromTheSetPointGivesNoDerivativeKick) {
  servo_.BeginFrame(At(0.01), 0);
  EXPECT_LT(servo_.Drive(0, 0), 15);  // 5.5 * 2.44 counts; the kick would add 9.8
}

TEST_F(ServoTest, LimpFrictionIsSmallAndOpposesMotion) {
  servo_.BeginFrame({}, 0);
  const TorqueLine line = servo_.Step(0, 1.0, kStep_s);
  EXPECT_EQ(line.zero_speed_nm, 0);
  EXPECT_NEAR(line.slope_nm_s * 1.0, 0.01 * joint_.stall_torque_nm, 1e-12);
}

TEST_F(ServoTest, StopPushesBackAlsoALimpJoint) {
  servo_.BeginFrame({}, 0);
  EXPECT_LT(servo_.Step(joint_.hard_rad.max + 0.01, 0, kStep_s).zero_speed_nm, 0);
  EXPECT_GT(servo_.Step(joint_.hard_rad.min - 0.01, 0, kStep_s).zero_speed_nm, 0);
}

TEST_F(ServoTest, StopHoldsAgainstFullDriveWithinADegree) {
  servo_.BeginFrame(At(joint_.hard_rad.max + 1), 0);
  EXPECT_LT(servo_.Step(joint_.hard_rad.max + Radians(1), 0, kStep_s).zero_speed_nm, 0);
}

}  // namespace
}  // namespace openr_host
