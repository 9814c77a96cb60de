// LOG of the remote control: the key frames of motions as in Hohl 2004, tables 3.9 and 3.10.
#include <gtest/gtest.h>

#include "RemoteLog.h"
#include "remote_robot.h"

namespace openr_host {
namespace {

using Bytes = std::vector<uint8_t>;

class MotionLogTest : public testing::Test {
 protected:
  // A report of JointMover in which joint j is commanded to j degrees and measured at -j degrees.
  void Report(int key_frame) {
    SetValueMessage message = {};
    message.state = key_frame < 0 ? moverACCEPTING_COMMANDS : moverMTN;
    message.keyFrame = key_frame;
    for (int j = 0; j < 18; ++j) {
      message.commanded[j] = j * 17453;
      message.measured[j] = -j * 17453;
    }
    robot_.handler.SetMover(message);
  }
  int Ask(uint32_t number) {
    Bytes payload;
    Append32(&payload, number);
    return robot_.Ask(rcLOG, payload, RC_VERSION_FILES);
  }
  // The head of the answer; the records are in records_.
  RcLogHead Head(uint32_t number) {
    EXPECT_EQ(Ask(number), rcOK) << robot_.error;
    RcReader in(robot_.payload.data(), static_cast<int>(robot_.payload.size()));
    RcLogHead head;
    head.Read(&in);
    EXPECT_EQ(in.RestSize(), head.here * head.size);
    records_.assign(in.Rest(), in.Rest() + in.RestSize());
    return head;
  }

  RemoteRobot robot_;
  Bytes records_;
};

TEST_F(MotionLogTest, ARecordIsThatOfTable39) {
  SensorValues values = {};
  values.frame = 2500;
  const RobotConstants* const robot = FindRobot("ERS-210");
  values.sensor[FindSensor(robot, "PRM:/r3/c1/c2/c3/c4-Sensor:s4")] = 1;
  values.sensor[FindSensor(robot, "PRM:/r1/c1/c2/c3/c4/s5-Sensor:s5")] = 1;  // chin: not logged
  robot_.handler.SetSensors(values);
  Report(300);
  const RcLogHead head = Head(0);
  EXPECT_EQ(head.size, 72);
  EXPECT_EQ(head.here, 1);
  EXPECT_EQ(head.state, moverMTN);
  Bytes wanted;
  Append16(&wanted, 300);
  const std::vector<int> joints = {0, 1, 2, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  for (const int joint : joints) Append16(&wanted, joint * 100);
  wanted.push_back(19);
  for (const int joint : joints) Append16(&wanted, -joint * 100);
  for (const int paw : {0, 1, 0, 0}) Append16(&wanted, paw);
  wanted.push_back(0);
  EXPECT_EQ(records_, wanted);
}

TEST_F(MotionLogTest, OnlyKeyFramesAreRecorded) {
  Report(-1);
  Report(0);
  Report(2);
  Report(-1);
  const RcLogHead head = Head(0);
  EXPECT_EQ(head.count, 2u);
  EXPECT_EQ(head.here, 2);
  EXPECT_EQ(records_[0], 0);
  EXPECT_EQ(records_[72], 2);
  EXPECT_EQ(head.state, moverACCEPTING_COMMANDS);
}

TEST_F(MotionLogTest, RecordsComeInPartsFromTheNumberAskedFor) {
  for (int i = 0; i < 30; ++i) Report(i);
  EXPECT_EQ(Head(0).here, 13) << "as many as a packet has room for";
  const RcLogHead next = Head(13);
  EXPECT_EQ(next.first, 13u);
  EXPECT_EQ(next.here, 13);
  EXPECT_EQ(records_[0], 13);
  EXPECT_EQ(Head(26).here, 4);
  EXPECT_EQ(Head(30).here, 0) << "the next one is not there yet";
  EXPECT_EQ(Head(30).count, 30u);
}

TEST_F(MotionLogTest, OldRecordsMakeRoomForNewOnes) {
  for (int i = 0; i < 300; ++i) Report(i);
  const RcLogHead head = Head(5);
  EXPECT_EQ(head.count, 300u);
  EXPECT_EQ(head.first, 44u) << "39 records are lost for a client that comes now";
  EXPECT_EQ(records_[0], 44);
  EXPECT_EQ(Head(299).here, 1);
}

TEST_F(MotionLogTest, TheEndTellsTheNumberOfRecordsOnly) {
  for (int i = 0; i < 7; ++i) Report(i);
  const RcLogHead head = Head(RC_LOG_END);
  EXPECT_EQ(head.count, 7u);
  EXPECT_EQ(head.first, 7u);
  EXPECT_EQ(head.here, 0);
}

TEST_F(MotionLogTest, RecordsThatAreNotThereAreRefused) {
  EXPECT_EQ(Ask(1), rcerrorBAD_VALUE);
  EXPECT_EQ(robot_.error, "record 1, but there are 0 so far");
  EXPECT_EQ(robot_.Ask(rcLOG, {0, 0, 0}, RC_VERSION_FILES), rcerrorMALFORMED);
  EXPECT_EQ(robot_.Ask(rcLOG, {0, 0, 0, 0}, RC_VERSION), rcerrorNOT_IMPLEMENTED);
}

}  // namespace
}  // namespace openr_host
