// MOTOR_OFF, MOTOR_ON, GAINS and POWER of the remote control.
#include <gtest/gtest.h>

#include "Angle.h"
#include "remote_robot.h"

namespace openr_host {
namespace {

class MotorRequestsTest : public testing::Test {
 protected:
  int Ask(int command, const std::vector<uint8_t>& payload) {
    return robot_.Ask(command, payload, RC_VERSION_FILES);
  }
  RemoteRobot robot_;
};

TEST_F(MotorRequestsTest, OneMotorOrAllAreSwitched) {
  EXPECT_EQ(Ask(rcMOTOR_OFF, {3}), rcOK);
  EXPECT_EQ(Ask(rcMOTOR_ON, {3}), rcOK);
  EXPECT_EQ(Ask(rcMOTOR_OFF, {RC_ALL_JOINTS}), rcOK);
  EXPECT_EQ(Ask(rcMOTOR_ON, {RC_ALL_JOINTS}), rcOK);
  ASSERT_EQ(robot_.commands.size(), 4u);
  EXPECT_EQ(robot_.commands[0].kind, moverkindMOTOR_OFF);
  EXPECT_EQ(robot_.commands[0].joint, 3);
  EXPECT_EQ(robot_.commands[1].kind, moverkindMOTOR_ON);
  EXPECT_EQ(robot_.commands[2].joint, MOVER_ALL_JOINTS);
  EXPECT_EQ(robot_.commands[3].joint, MOVER_ALL_JOINTS);
}

std::vector<uint8_t> TrackRequest(int joint, int32_t cdeg, int frames) {
  std::vector<uint8_t> request = RemoteRobot::JointValue(joint, cdeg);
  request.push_back(static_cast<uint8_t>(frames));
  return request;
}

TEST_F(MotorRequestsTest, TrackTellsThePositionInForceAndSendsItWithItsFrames) {
  ASSERT_EQ(Ask(rcTRACK, TrackRequest(1, 1'000'000, 4)), rcOK);
  ASSERT_EQ(robot_.commands.size(), 1u);
  EXPECT_EQ(robot_.commands[0].kind, moverkindTRACK);
  EXPECT_EQ(robot_.commands[0].joint, 1);
  EXPECT_EQ(robot_.commands[0].frames, 4);
  EXPECT_EQ(robot_.commands[0].value, UradFromCdeg(FindRobot("ERS-210")->joints[1].maxCdeg));
}

TEST_F(MotorRequestsTest, TrackIsRefusedWithoutFramesDuringAMotionAndInVersion1) {
  EXPECT_EQ(Ask(rcTRACK, TrackRequest(1, 0, 0)), rcerrorBAD_VALUE);
  EXPECT_EQ(Ask(rcTRACK, TrackRequest(99, 0, 4)), rcerrorNO_SUCH_DEVICE);
  EXPECT_EQ(Ask(rcTRACK, RemoteRobot::JointValue(1, 0)), rcerrorMALFORMED);
  EXPECT_EQ(robot_.Ask(rcTRACK, TrackRequest(1, 0, 4), RC_VERSION), rcerrorUNKNOWN_COMMAND);
  robot_.Say(moverMTN, 3);
  EXPECT_EQ(Ask(rcTRACK, TrackRequest(1, 0, 4)), rcerrorBUSY);
  EXPECT_TRUE(robot_.commands.empty());
}

TEST_F(MotorRequestsTest, WithoutPowerMovementsAreBusyInBothVersions) {
  robot_.AddMotion("NOD.MTN", MtnBytes::OneJoint("PRM:/r1/c1-Joint2:j1", {0, 10}).Bytes());
  ASSERT_EQ(Ask(rcMOTOR_OFF, {RC_ALL_JOINTS}), rcOK);
  for (const int version : {RC_VERSION, RC_VERSION_FILES}) {
    EXPECT_EQ(robot_.Ask(rcMOVE, RemoteRobot::JointValue(1, 0), version), rcerrorBUSY);
    EXPECT_EQ(robot_.error, "the motors are off; MOTOR_ON for all joints (255) switches them on");
    EXPECT_EQ(robot_.Ask(rcMTN_PLAY, RemoteRobot::PlayRequest("NOD.MTN"), version), rcerrorBUSY);
    EXPECT_EQ(robot_.Ask(rcSPEED, RemoteRobot::JointValue(1, 5000), version), rcOK);
    EXPECT_EQ(robot_.Ask(rcMTN_STOP, {}, version), rcOK);
  }
  EXPECT_EQ(Ask(rcMOTOR_ON, {3}), rcerrorBUSY) << "a joint cannot be on while all are off";
  ASSERT_EQ(Ask(rcMOTOR_ON, {RC_ALL_JOINTS}), rcOK);
  EXPECT_EQ(Ask(rcMOVE, RemoteRobot::JointValue(1, 0)), rcOK);
}

TEST_F(MotorRequestsTest, JointMoversReportOfTheMotorsHolds) {
  robot_.Say(moverACCEPTING_COMMANDS, -1, true);
  EXPECT_EQ(Ask(rcMOVE, RemoteRobot::JointValue(1, 0)), rcerrorBUSY);
  robot_.Say(moverACCEPTING_COMMANDS, -1, false);
  EXPECT_EQ(Ask(rcMOVE, RemoteRobot::JointValue(1, 0)), rcOK);
}

TEST_F(MotorRequestsTest, MotorsAreSwitchedOffDuringAMotionAndItsEndIsAssumed) {
  robot_.Say(moverMTN, 3);
  EXPECT_EQ(Ask(rcMOTOR_OFF, {RC_ALL_JOINTS}), rcOK);
  ASSERT_EQ(Ask(rcINFO, {}), rcOK);
  EXPECT_EQ(robot_.Payload<RcInfo>().state, moverACCEPTING_COMMANDS);
}

TEST_F(MotorRequestsTest, MotorsThatCannotBeSwitchedAreRefused) {
  EXPECT_EQ(Ask(rcMOTOR_OFF, {18}), rcerrorNO_SUCH_DEVICE);
  EXPECT_EQ(robot_.error, "joint 18: the ERS-210 has 18, counted from 0");
  EXPECT_EQ(Ask(rcMOTOR_OFF, {}), rcerrorMALFORMED);
  EXPECT_EQ(Ask(rcMOTOR_ON, {1, 1}), rcerrorMALFORMED);
  EXPECT_EQ(robot_.Ask(rcMOTOR_OFF, {1}, RC_VERSION), rcerrorUNKNOWN_COMMAND);
  robot_.full = true;
  EXPECT_EQ(Ask(rcMOTOR_OFF, {RC_ALL_JOINTS}), rcerrorBUSY);
  robot_.full = false;
  EXPECT_EQ(Ask(rcMOVE, RemoteRobot::JointValue(1, 0)), rcOK) << "the motors were not switched";
  robot_.commands.clear();
  robot_.Say(moverCROUCHING, -1);
  EXPECT_EQ(Ask(rcMOTOR_OFF, {RC_ALL_JOINTS}), rcerrorBUSY);
  EXPECT_TRUE(robot_.commands.empty());
}

TEST_F(MotorRequestsTest, GainsAreToldAsTheRobotHasThem) {
  ASSERT_EQ(Ask(rcGAINS, {4}), rcOK);
  const RcGains gains = robot_.Payload<RcGains>();
  EXPECT_EQ(gains.isOn, 1);
  EXPECT_EQ((std::vector<int>{gains.gain[0], gains.gain[1], gains.gain[2]}),
            (std::vector<int>{22, 4, 8}));
  EXPECT_EQ((std::vector<int>{gains.shift[0], gains.shift[1], gains.shift[2]}),
            (std::vector<int>{14, 2, 15}));
  robot_.limp = true;
  ASSERT_EQ(Ask(rcGAINS, {4}), rcOK);
  EXPECT_EQ(robot_.Payload<RcGains>().isOn, 0);
  EXPECT_EQ(robot_.Payload<RcGains>().gain[0], 0);
  EXPECT_TRUE(robot_.commands.empty());
}

TEST_F(MotorRequestsTest, GainsAreSetAndAnsweredAtOnce) {
  ASSERT_EQ(Ask(rcGAINS, {4, 127, 0, 0, 0, 3, 0}), rcOK) << robot_.error;
  const RcGains gains = robot_.Payload<RcGains>();
  EXPECT_EQ(gains.gain[0], 127);
  EXPECT_EQ(gains.gain[2], 3);
  ASSERT_EQ(robot_.commands.size(), 1u);
  EXPECT_EQ(robot_.commands[0].kind, moverkindGAINS);
  EXPECT_EQ(robot_.commands[0].joint, 4);
  EXPECT_EQ(robot_.commands[0].gain[0], 127);
  EXPECT_EQ(robot_.commands[0].gain[1], 0);
  EXPECT_EQ(robot_.commands[0].gain[2], 3);
}

TEST_F(MotorRequestsTest, GainsOutOfRangeAreRefused) {
  EXPECT_EQ(Ask(rcGAINS, {4, 22, 0, 128, 0, 8, 0}), rcerrorBAD_VALUE);
  EXPECT_EQ(robot_.error, "I gain 128, must be 0 to 127");
  EXPECT_EQ(Ask(rcGAINS, {18}), rcerrorNO_SUCH_DEVICE);
  EXPECT_EQ(Ask(rcGAINS, {4, 1, 0, 1, 0, 1}), rcerrorMALFORMED);
  EXPECT_EQ(Ask(rcGAINS, {4, 1, 0, 1, 0, 1, 0, 0}), rcerrorMALFORMED);
  EXPECT_EQ(Ask(rcGAINS, {}), rcerrorMALFORMED);
  robot_.full = true;
  EXPECT_EQ(Ask(rcGAINS, {4, 1, 0, 1, 0, 1, 0}), rcerrorBUSY);
  EXPECT_EQ(Ask(rcGAINS, {4}), rcOK) << "to tell them needs no JointMover";
  robot_.full = false;
  robot_.Say(moverCROUCHING, -1);
  EXPECT_EQ(Ask(rcGAINS, {4, 1, 0, 1, 0, 1, 0}), rcerrorBUSY);
  EXPECT_EQ(Ask(rcGAINS, {4}), rcOK);
  EXPECT_TRUE(robot_.commands.empty());
}

TEST_F(MotorRequestsTest, PowerIsToldWhole) {
  ASSERT_EQ(Ask(rcPOWER, {}), rcOK);
  EXPECT_EQ(robot_.payload.size(), 20u);
  const RcPower power = robot_.Payload<RcPower>();
  EXPECT_EQ(power.robotStatus, 0x12345678u);
  EXPECT_EQ(power.batteryStatus, 0x90);
  EXPECT_EQ(power.capacity, 87);
  EXPECT_EQ(power.fullCapacity, 2000);
  EXPECT_EQ(power.voltage, 7400);
  EXPECT_EQ(power.current, -1300);
  EXPECT_EQ(power.temperature, 2500);
}

TEST_F(MotorRequestsTest, PowerThatIsNotToldIsBusy) {
  robot_.tells_power = false;
  EXPECT_EQ(Ask(rcPOWER, {}), rcerrorBUSY);
  EXPECT_EQ(robot_.error, "the robot does not tell its power status now; try again");
  EXPECT_EQ(Ask(rcPOWER, {0}), rcerrorMALFORMED);
  EXPECT_EQ(robot_.Ask(rcPOWER, {}, RC_VERSION), rcerrorUNKNOWN_COMMAND);
}

}  // namespace
}  // namespace openr_host
