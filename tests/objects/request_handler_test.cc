#include <gtest/gtest.h>

#include <random>

#include "ImageFile.h"
#include "mtn_bytes.h"
#include "remote_robot.h"

namespace openr_host {
namespace {

using Robot = RemoteRobot;

const std::vector<uint8_t> kMotion =
    MtnBytes::OneJoint("PRM:/r1/c1-Joint2:j1", {0, 10, 20}).Bytes();

TEST(RequestHandlerTest, InfoTellsTheCountsOfTable38) {
  Robot robot;
  ASSERT_EQ(robot.Ask(rcINFO, {}), rcOK);
  const RcInfo info = robot.Payload<RcInfo>();
  EXPECT_EQ(info.design, "ERS-210");
  EXPECT_EQ(info.numJoints, 18);
  EXPECT_EQ(info.numBinary, 6);
  EXPECT_EQ(info.numOther, 7);
  EXPECT_EQ(info.numMisc, 2);
  EXPECT_EQ(info.numLeds, 9);
  EXPECT_EQ(info.numEars, 2);
  EXPECT_EQ(info.state, moverACCEPTING_COMMANDS);
}

TEST(RequestHandlerTest, DescribesAJointWithItsLimits) {
  Robot robot;
  ASSERT_EQ(robot.Ask(rcDESCRIBE, {rcdeviceJOINT, 4}), rcOK);
  const RcDescription joint = robot.Payload<RcDescription>();
  EXPECT_EQ(joint.name, "LF_j1");
  EXPECT_EQ(joint.title, "Left fore leg J1");
  EXPECT_EQ(joint.locator, "PRM:/r2/c1-Joint2:j1");
  EXPECT_EQ(joint.values, (std::vector<int32_t>{-11700, 11700, 250, 16125, 313, 31250, 4883}));
}

TEST(RequestHandlerTest, DescribesSensorsInTheOrderOfTheirGroups) {
  Robot robot;
  std::vector<std::string> titles;
  for (uint8_t i = 0; i < 6; ++i) {
    ASSERT_EQ(robot.Ask(rcDESCRIBE, {rcdeviceBINARY, i}), rcOK);
    titles.push_back(robot.Payload<RcDescription>().title);
  }
  EXPECT_EQ(titles,
            (std::vector<std::string>{"Chin switch", "Paw sensor (left fore leg)",
                                      "Paw sensor (left hind leg)", "Paw sensor (right fore leg)",
                                      "Paw sensor (right hind leg)", "Back sensor"}));
  EXPECT_EQ(robot.Ask(rcDESCRIBE, {rcdeviceBINARY, 6}), rcerrorNO_SUCH_DEVICE);
  EXPECT_EQ(robot.Ask(rcDESCRIBE, {rcdeviceOTHER, 6}), rcOK);
  EXPECT_EQ(robot.Ask(rcDESCRIBE, {5, 0}), rcerrorNO_SUCH_DEVICE);
}

TEST(RequestHandlerTest, SensorsComeInGroups) {
  Robot robot;
  robot.Say(moverMTN, 12);
  ASSERT_EQ(robot.Ask(rcSENSORS, {}), rcOK);
  const RcSensors sensors = robot.Payload<RcSensors>();
  ASSERT_EQ(sensors.joints.size(), 18u);
  EXPECT_EQ(sensors.joints[17], 1700);
  EXPECT_EQ(sensors.binary.size(), 6u);
  EXPECT_EQ(sensors.other.size(), 7u);
  EXPECT_EQ(sensors.misc, (std::vector<int32_t>{87, 2500}));
  EXPECT_EQ(sensors.keyFrame, (std::vector<int32_t>{12}));
  EXPECT_EQ(sensors.state, moverMTN);
}

TEST(RequestHandlerTest, GetTellsPositionAndLimits) {
  Robot robot;
  ASSERT_EQ(robot.Ask(rcGET, {2}), rcOK);
  const RcJointState state = robot.Payload<RcJointState>();
  EXPECT_EQ(state.position, 200);
  EXPECT_EQ(state.speed, 17250);
  EXPECT_EQ(state.acceleration, 4883);
}

TEST(RequestHandlerTest, MoveAnswersWithThePositionInForce) {
  Robot robot;
  ASSERT_EQ(robot.Ask(rcMOVE, Robot::JointValue(1, 3000)), rcOK);
  EXPECT_EQ(robot.Number(), 3000);
  ASSERT_EQ(robot.commands.size(), 1u);
  EXPECT_EQ(robot.commands[0].kind, moverkindPOSITION);
  EXPECT_EQ(robot.commands[0].joint, 1);
  EXPECT_EQ(robot.commands[0].value, 523599);
}

TEST(RequestHandlerTest, MoveBeyondTheLimitEndsAtTheLimit) {
  Robot robot;
  ASSERT_EQ(robot.Ask(rcMOVE, Robot::JointValue(0, 9000)), rcOK);
  EXPECT_EQ(robot.Number(), 4300);
  ASSERT_EQ(robot.Ask(rcMOVE, Robot::JointValue(0, -2147483647 - 1)), rcOK);
  EXPECT_EQ(robot.Number(), -8200);
}

TEST(RequestHandlerTest, SpeedAndAccelerationAreLimitedAndRemembered) {
  Robot robot;
  ASSERT_EQ(robot.Ask(rcSPEED, Robot::JointValue(0, 100000)), rcOK);
  EXPECT_EQ(robot.Number(), 12062);
  ASSERT_EQ(robot.Ask(rcSPEED, Robot::JointValue(0, 5000)), rcOK);
  ASSERT_EQ(robot.Ask(rcACCEL, Robot::JointValue(0, 1)), rcOK);
  EXPECT_EQ(robot.Number(), 313);
  ASSERT_EQ(robot.Ask(rcGET, {0}), rcOK);
  const RcJointState state = robot.Payload<RcJointState>();
  EXPECT_EQ(state.speed, 5000);
  EXPECT_EQ(state.acceleration, 313);
}

TEST(RequestHandlerTest, JointsThatDoNotExistAreNamed) {
  Robot robot;
  EXPECT_EQ(robot.Ask(rcMOVE, Robot::JointValue(18, 0)), rcerrorNO_SUCH_DEVICE);
  EXPECT_EQ(robot.error, "joint 18: the ERS-210 has 18, counted from 0");
  EXPECT_EQ(robot.Ask(rcGET, {255}), rcerrorNO_SUCH_DEVICE);
  EXPECT_TRUE(robot.commands.empty());
}

TEST(RequestHandlerTest, BeforeTheRobotStandsItIsBusyAndSaysWhere) {
  Robot robot;
  robot.Say(moverCROUCHING, -1);
  for (const int command : {rcMOVE, rcSPEED, rcACCEL}) {
    EXPECT_EQ(robot.Ask(command, Robot::JointValue(1, 3000)), rcerrorBUSY);
  }
  EXPECT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest("WALK.MTN")), rcerrorBUSY);
  EXPECT_EQ(robot.Ask(rcMTN_STOP, {}), rcerrorBUSY);
  EXPECT_EQ(robot.error, "the robot is still on its way to its standing posture (crouching)");
  EXPECT_TRUE(robot.commands.empty());
  EXPECT_EQ(robot.Ask(rcSENSORS, {}), rcOK);
  EXPECT_EQ(robot.Ask(rcLED, {0, 1}), rcOK);
}

// An RCServer that replaces another one while the robot stands hears of no change of state.
TEST(RequestHandlerTest, AMoverThatTakesCommandsStands) {
  Robot robot;
  robot.Say(-1, -1);  // nothing yet
  EXPECT_EQ(robot.Ask(rcMOVE, Robot::JointValue(1, 3000)), rcerrorBUSY);
  robot.handler.MoverIsReady();
  EXPECT_EQ(robot.Ask(rcMOVE, Robot::JointValue(1, 3000)), rcOK);
}

TEST(RequestHandlerTest, WhatTheMoverSaysOfItsStateHolds) {
  Robot robot;
  robot.Say(moverCROUCHING, -1);
  robot.handler.MoverIsReady();
  EXPECT_EQ(robot.Ask(rcMOVE, Robot::JointValue(1, 3000)), rcerrorBUSY);
}

TEST(RequestHandlerTest, MoveDuringAMotionIsBusyButLimitsAreNot) {
  Robot robot;
  robot.Say(moverMTN, 3);
  EXPECT_EQ(robot.Ask(rcMOVE, Robot::JointValue(1, 3000)), rcerrorBUSY);
  EXPECT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest("WALK.MTN")), rcerrorBUSY);
  EXPECT_EQ(robot.Ask(rcSPEED, Robot::JointValue(1, 3000)), rcOK);
  EXPECT_EQ(robot.Ask(rcMTN_STOP, {}), rcOK);
}

TEST(RequestHandlerTest, AFullQueueIsBusyAndChangesNothing) {
  Robot robot;
  robot.full = true;
  EXPECT_EQ(robot.Ask(rcSPEED, Robot::JointValue(0, 5000)), rcerrorBUSY);
  robot.full = false;
  ASSERT_EQ(robot.Ask(rcGET, {0}), rcOK);
  EXPECT_EQ(robot.Payload<RcJointState>().speed, 12062);
}

TEST(RequestHandlerTest, LedsAndEarsAreBitsOfAChange) {
  Robot robot;
  ASSERT_EQ(robot.Ask(rcLED, {8, 1}), rcOK);
  ASSERT_EQ(robot.Ask(rcEAR, {1, 0}), rcOK);
  ASSERT_EQ(robot.lights.size(), 2u);
  EXPECT_EQ(robot.lights[0].ledMask, 1u << 8);
  EXPECT_EQ(robot.lights[0].ledOn, 1u << 8);
  EXPECT_EQ(robot.lights[1].earMask, 2u);
  EXPECT_EQ(robot.lights[1].earOn, 0u);
  EXPECT_EQ(robot.Ask(rcLED, {9, 1}), rcerrorNO_SUCH_DEVICE);
  EXPECT_EQ(robot.Ask(rcEAR, {2, 1}), rcerrorNO_SUCH_DEVICE);
  EXPECT_EQ(robot.Ask(rcLED, {0, 2}), rcerrorBAD_VALUE);
}

TEST(RequestHandlerTest, PlayChecksTheMotionAndTellsItsLength) {
  Robot robot;
  robot.AddMotion("NOD.MTN", kMotion);
  ASSERT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest("nod.mtn", 5)), rcOK) << robot.error;
  const RcPlayAnswer answer = robot.Payload<RcPlayAnswer>();
  EXPECT_EQ(answer.durationMs, 32u);
  EXPECT_EQ(answer.keyFrames, 3);
  EXPECT_EQ(answer.loops, 5);
  ASSERT_EQ(robot.commands.size(), 1u);
  EXPECT_EQ(robot.commands[0].kind, moverkindPLAY);
  EXPECT_EQ(robot.commands[0].loops, 5);
  EXPECT_STREQ(robot.commands[0].file, "NOD.MTN");
}

TEST(RequestHandlerTest, ASecondPlayIsBusyBeforeJointMoverHasSpoken) {
  Robot robot;
  robot.AddMotion("NOD.MTN", kMotion);
  ASSERT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest("NOD.MTN")), rcOK);
  EXPECT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest("NOD.MTN")), rcerrorBUSY);
}

TEST(RequestHandlerTest, PlayRefusesWhatCannotBePlayed) {
  Robot robot;
  robot.AddMotion("SEVEN.MTN", MtnBytes::OneJoint("PRM:/r1/c1-Joint2:11", {0, 1}).Bytes());
  robot.AddMotion("TEXT.MTN", {'h', 'e', 'l', 'l', 'o'});
  robot.AddMotion("EMPTY.MTN", {});
  EXPECT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest("NONE.MTN")), rcerrorNO_SUCH_FILE);
  EXPECT_EQ(robot.error, "/MS/OPEN-R/MW/DATA/P/NONE.MTN: no such file on the Memory Stick");
  EXPECT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest("../CONF/PASSWD")), rcerrorNO_SUCH_FILE);
  EXPECT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest(std::string("A\0B.MTN", 7))),
            rcerrorNO_SUCH_FILE);
  EXPECT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest("SEVEN.MTN")), rcerrorBAD_FILE);
  EXPECT_EQ(
      robot.error,
      "SEVEN.MTN: section 2, offset 86: joint 0: the ERS-210 has no joint 'PRM:/r1/c1-Joint2:11'");
  EXPECT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest("TEXT.MTN")), rcerrorBAD_FILE);
  EXPECT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest("EMPTY.MTN")), rcerrorBAD_FILE);
  EXPECT_EQ(robot.Ask(rcMTN_PLAY, Robot::PlayRequest("SEVEN.MTN", 0)), rcerrorBAD_VALUE);
  EXPECT_TRUE(robot.commands.empty());
}

TEST(RequestHandlerTest, AnotherProtocolVersionIsRefused) {
  Robot robot;
  for (const int version : {0, 3, 255}) {
    EXPECT_EQ(robot.Ask(rcINFO, {}, version), rcerrorVERSION);
    EXPECT_EQ(robot.version, RC_VERSION) << "a version that every client knows";
  }
  EXPECT_EQ(robot.error, "protocol version 255 is not served, only 1 and 2");
}

TEST(RequestHandlerTest, AnAnswerHasTheVersionOfItsRequest) {
  Robot robot;
  for (const int version : {RC_VERSION, RC_VERSION_FILES}) {
    EXPECT_EQ(robot.Ask(rcSENSORS, {}, version), rcOK);
    EXPECT_EQ(robot.version, version);
    EXPECT_EQ(robot.Ask(rcGET, {99}, version), rcerrorNO_SUCH_DEVICE);
    EXPECT_EQ(robot.version, version);
  }
}

TEST(RequestHandlerTest, OnlyVersion2TellsAboutFiles) {
  Robot robot;
  ASSERT_EQ(robot.Ask(rcINFO, {}), rcOK);
  const size_t size = robot.payload.size();
  EXPECT_FALSE(robot.Payload<RcInfo>().hasFiles);
  ASSERT_EQ(robot.Ask(rcINFO, {}, RC_VERSION_FILES), rcOK);
  EXPECT_EQ(robot.payload.size(), size + 9);
  const RcInfo info = robot.Payload<RcInfo>();
  EXPECT_TRUE(info.hasFiles);
  EXPECT_EQ(info.design, "ERS-210");
  EXPECT_EQ(info.processor, OwnProcessor());
  EXPECT_EQ(info.largestMotion, RC_MAX_MOTION);
  EXPECT_EQ(info.largestImage, RC_MAX_IMAGE);
}

TEST(RequestHandlerTest, ReservedAndUnknownCommandsAreToldApart) {
  Robot robot;
  for (const int command : {0x42, 0x50, 0x51, 0x52, 0x53, 0x60, 0x70, 0x71}) {
    EXPECT_EQ(robot.Ask(command, {1, 2, 3}), rcerrorNOT_IMPLEMENTED) << command;
  }
  EXPECT_EQ(robot.Ask(0xff, {}), rcerrorUNKNOWN_COMMAND);
  EXPECT_EQ(robot.Ask(rcDOWNLOAD, {}), rcerrorUNKNOWN_COMMAND) << "version 1 does not reserve it";
  EXPECT_EQ(robot.Ask(rcLOG, {}, RC_VERSION_FILES), rcerrorMALFORMED) << "version 2 has it";
  EXPECT_EQ(robot.Ask(0xff, {}, RC_VERSION_FILES), rcerrorUNKNOWN_COMMAND);
}

TEST(RequestHandlerTest, PayloadsOfTheWrongLengthAreMalformed) {
  Robot robot;
  EXPECT_EQ(robot.Ask(rcINFO, {0}), rcerrorMALFORMED);
  EXPECT_EQ(robot.Ask(rcSENSORS, {0}), rcerrorMALFORMED);
  EXPECT_EQ(robot.Ask(rcMOVE, {1, 2, 3, 4}), rcerrorMALFORMED);
  EXPECT_EQ(robot.Ask(rcMOVE, {1, 2, 3, 4, 5, 6}), rcerrorMALFORMED);
  EXPECT_EQ(robot.Ask(rcLED, {1}), rcerrorMALFORMED);
  EXPECT_EQ(robot.Ask(rcGET, {}), rcerrorMALFORMED);
  EXPECT_EQ(robot.Ask(rcMTN_PLAY, {200, 'a'}), rcerrorMALFORMED);
  EXPECT_EQ(robot.Ask(rcMTN_STOP, {1}), rcerrorMALFORMED);
  EXPECT_EQ(robot.Ask(rcDESCRIBE, {0}), rcerrorMALFORMED);
}

TEST(RequestHandlerTest, RandomRequestsAlwaysGetAnAnswer) {
  Robot robot;
  robot.AddMotion("A.B", kMotion);
  std::mt19937 random(11);
  for (int i = 0; i < 5000; ++i) {
    std::vector<uint8_t> payload(random() % 12);
    for (uint8_t& byte : payload)
      byte = static_cast<uint8_t>(random() % 4 == 0 ? random() : random() % 8);
    robot.Ask(static_cast<int>(random() % 256), payload);
  }
}

TEST(RequestHandlerTest, BytesThatAreNoPacketGetALastAnswer) {
  Robot robot;
  uint8_t answer[RC_MAX_PACKET];
  RcWriter out(answer, RC_MAX_PACKET);
  robot.handler.AnswerBroken("no packet", &out);
  EXPECT_EQ(robot.ReadAnswer(answer, out.Size(), 0, 0), rcerrorBAD_PACKET);
  EXPECT_EQ(robot.error, "no packet");
}

}  // namespace
}  // namespace openr_host
