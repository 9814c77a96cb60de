// BATCH of the remote control: several requests in one packet.
#include <gtest/gtest.h>

#include "remote_robot.h"

namespace openr_host {
namespace {

using Bytes = std::vector<uint8_t>;

// An answer to a request in a batch.
struct Part {
  int command = 0, tag = 0, version = 0, status = 0;
  Bytes payload;
  std::string error;
};

class BatchTest : public testing::Test {
 protected:
  void Add(int command, const Bytes& payload, int version = RC_VERSION_FILES) {
    const Bytes packet = RemoteRobot::Packet(command, payload, version, next_tag_++);
    batch_.insert(batch_.end(), packet.begin(), packet.end());
  }

  int Send() { return robot_.Ask(rcBATCH, batch_, RC_VERSION_FILES); }

  // Sends the batch, which must be accepted, and returns the answers to its parts.
  std::vector<Part> Answers() {
    EXPECT_EQ(Send(), rcOK) << robot_.error;
    std::vector<Part> parts;
    RcFramer framer;
    framer.Append(robot_.payload.data(), static_cast<int>(robot_.payload.size()));
    while (framer.Next() == RcFramer::PACKET) {
      RcAnswerHeader header;
      EXPECT_TRUE(header.Read(framer));
      EXPECT_EQ(header.frame, 2500u);
      const Uint8* const begin = framer.Payload() + RC_ANSWER_HEADER_SIZE - RC_HEADER_SIZE;
      const Uint8* const end = framer.Payload() + framer.PayloadSize();
      Part part{header.header.command, header.header.tag, header.header.version,
                header.status,         Bytes(begin, end), ""};
      RcReader in(begin, static_cast<int>(end - begin));
      if (part.status != rcOK) part.error = in.String();
      parts.push_back(part);
    }
    return parts;
  }

  RemoteRobot robot_;
  Bytes batch_;
  int next_tag_ = 100;
};

TEST_F(BatchTest, RequestsAreAnsweredInTheirOrderWithTheirTags) {
  Add(rcMOVE, RemoteRobot::JointValue(1, 3000));
  Add(rcLED, {8, 1}, RC_VERSION);
  Add(rcGET, {2});
  const std::vector<Part> parts = Answers();
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].command, rcMOVE);
  EXPECT_EQ(parts[0].tag, 100);
  EXPECT_EQ(parts[1].tag, 101);
  EXPECT_EQ(parts[1].version, RC_VERSION);
  EXPECT_EQ(parts[1].payload, Bytes{1});
  EXPECT_EQ(parts[2].version, RC_VERSION_FILES);
  EXPECT_EQ(parts[2].payload.size(), 12u);
  EXPECT_EQ(robot_.commands.size(), 1u);
  EXPECT_EQ(robot_.lights.size(), 1u);
}

TEST_F(BatchTest, ARefusedRequestDoesNotStopTheOthers) {
  Add(rcMOVE, RemoteRobot::JointValue(99, 0));
  Add(rcMOVE, {1, 2});
  Add(0xee, {});
  Add(rcMOVE, RemoteRobot::JointValue(0, 0), 9);
  Add(rcMOVE, RemoteRobot::JointValue(0, 0));
  const std::vector<Part> parts = Answers();
  ASSERT_EQ(parts.size(), 5u);
  EXPECT_EQ(parts[0].status, rcerrorNO_SUCH_DEVICE);
  EXPECT_EQ(parts[0].error, "joint 99: the ERS-210 has 18, counted from 0");
  EXPECT_EQ(parts[1].status, rcerrorMALFORMED);
  EXPECT_EQ(parts[2].status, rcerrorUNKNOWN_COMMAND);
  EXPECT_EQ(parts[3].status, rcerrorVERSION);
  EXPECT_EQ(parts[3].version, RC_VERSION);
  EXPECT_EQ(parts[4].status, rcOK);
  EXPECT_EQ(robot_.commands.size(), 1u);
}

TEST_F(BatchTest, AllJointsMoveWithOnePacket) {
  for (int j = 0; j < 18; ++j) Add(rcMOVE, RemoteRobot::JointValue(j, 0));
  EXPECT_EQ(Answers().size(), 18u);
  EXPECT_EQ(robot_.commands.size(), 18u);
}

TEST_F(BatchTest, BatchesUploadsAndTheEndAreNoPartsOfABatch) {
  const std::vector<int> commands = {rcBATCH,      rcUPLOAD_BEGIN, rcUPLOAD_DATA,
                                     rcUPLOAD_END, rcREBOOT,       rcSHUTDOWN};
  for (const int command : commands) Add(command, {});
  const std::vector<Part> parts = Answers();
  ASSERT_EQ(parts.size(), commands.size());
  for (const Part& part : parts) {
    EXPECT_EQ(part.status, rcerrorNOT_IN_BATCH) << part.command;
    EXPECT_EQ(part.error, "must not be in a batch");
  }
}

TEST_F(BatchTest, AnAnswerWithoutRoomIsReplacedByAnError) {
  for (int i = 0; i < RC_MAX_BATCH; ++i) Add(rcSENSORS, {});
  const std::vector<Part> parts = Answers();
  ASSERT_EQ(parts.size(), static_cast<size_t>(RC_MAX_BATCH));
  EXPECT_EQ(parts[0].status, rcerrorTOO_LONG) << "24 answers must still fit behind it";
  EXPECT_EQ(parts[0].error, "the answer has no room");
  EXPECT_EQ(parts.back().status, rcerrorTOO_LONG);
}

TEST_F(BatchTest, LongAnswersFitWhileThereIsRoom) {
  for (int i = 0; i < 7; ++i) Add(rcSENSORS, {});
  const std::vector<Part> parts = Answers();
  ASSERT_EQ(parts.size(), 7u);
  EXPECT_EQ(parts[5].status, rcOK);
  EXPECT_EQ(parts[6].status, rcerrorTOO_LONG) << "an answer has 160 bytes";
}

TEST_F(BatchTest, ALongErrorTextIsCutOffWhereTheRoomEnds) {
  for (int i = 0; i < RC_MAX_BATCH; ++i) Add(rcMTN_PLAY, RemoteRobot::PlayRequest("NONE.MTN"));
  for (const Part& part : Answers()) {
    EXPECT_EQ(part.status, rcerrorNO_SUCH_FILE);
    EXPECT_EQ(part.error.substr(0, 23), "/MS/OPEN-R/MW/DATA/P/NO");
  }
}

TEST_F(BatchTest, AnswersWithAnEffectAreNeverTooLong) {
  robot_.AddMotion("NOD.MTN", MtnBytes::OneJoint("PRM:/r1/c1-Joint2:j1", {0, 10}).Bytes());
  const std::vector<std::pair<int, Bytes>> requests = {
      {rcMOVE, RemoteRobot::JointValue(0, 0)},
      {rcSPEED, RemoteRobot::JointValue(0, 5000)},
      {rcACCEL, RemoteRobot::JointValue(0, 99)},
      {rcLED, {0, 1}},
      {rcEAR, {0, 1}},
      {rcMTN_STOP, {}},
      {rcMOTOR_OFF, {0}},
      {rcMOTOR_ON, {0}},
      {rcGAINS, {0, 9, 0, 9, 0, 9, 0}},
      {rcCAMERA, {0}},
      {rcSUBSCRIBE, {0, 4, 0}},
      {rcUNSUBSCRIBE, {0}},
      {rcMTN_PLAY, RemoteRobot::PlayRequest("NOD.MTN")}};
  for (const auto& [command, payload] : requests) {
    batch_.clear();
    for (int i = 0; i < RC_MAX_BATCH; ++i) Add(command, payload);
    const std::vector<Part> parts = Answers();
    ASSERT_EQ(parts.size(), static_cast<size_t>(RC_MAX_BATCH));
    for (const Part& part : parts) EXPECT_NE(part.status, rcerrorTOO_LONG) << command;
    EXPECT_EQ(parts[0].status, rcOK) << command;
  }
}

// Also the robots with most devices and longest names.
TEST_F(BatchTest, NoAnswerIsTooLongForAPacket) {
  for (const char* design : {"ERS-210", "ERS-220", "ERS-7"}) {
    robot_.handler.Begin(FindRobot(design));
    for (const int command : {rcINFO, rcSENSORS, rcPOWER}) {
      EXPECT_EQ(robot_.Ask(command, {}, RC_VERSION_FILES), rcOK) << command;
    }
    for (uint8_t kind = 0; kind < NUM_RC_DEVICES; ++kind) {
      for (uint8_t i = 0; robot_.Ask(rcDESCRIBE, {kind, i}) == rcOK; ++i) {
        EXPECT_LE(robot_.payload.size(), 200u);
      }
      EXPECT_EQ(robot_.Ask(rcDESCRIBE, {kind, 99}), rcerrorNO_SUCH_DEVICE);
    }
    ASSERT_EQ(robot_.Ask(rcSUBSCRIBE, {0, 4, 0}, RC_VERSION_FILES), rcOK);
    ASSERT_EQ(robot_.Ask(rcSUBSCRIBE, {1, 0, 0}, RC_VERSION_FILES), rcOK);
    robot_.handler.SetSensors({2500, {}, {}});
    robot_.Say(moverMTN, 1);
    uint8_t bytes[RC_MAX_PACKET];
    RcWriter out(bytes, RC_MAX_PACKET);
    robot_.handler.WriteEvents(0, &out);
    EXPECT_FALSE(out.HasOverflowed());
    EXPECT_GT(out.Size(), 300);
  }
}

TEST_F(BatchTest, ABatchThatIsBrokenDoesNothing) {
  Add(rcMOVE, RemoteRobot::JointValue(1, 3000));
  const Bytes good = batch_;
  for (const Bytes& tail :
       {Bytes{'R'}, Bytes{'R', 'C', 7, 0, 2, rcINFO, 0, 0}, Bytes{'R', 'C', 9, 0, 2, rcINFO, 0, 0},
        Bytes{'X', 'C', 8, 0, 2, rcINFO, 0, 0}}) {
    batch_ = good;
    batch_.insert(batch_.end(), tail.begin(), tail.end());
    EXPECT_EQ(Send(), rcerrorMALFORMED);
    EXPECT_EQ(robot_.error,
              "request 1 of the batch, at byte 13 of the payload, is no whole packet; nothing was "
              "done");
  }
  EXPECT_TRUE(robot_.commands.empty());
}

TEST_F(BatchTest, NoneAndTooManyRequestsAreRefused) {
  EXPECT_EQ(Send(), rcerrorBAD_VALUE);
  EXPECT_EQ(robot_.error, "0 requests, a batch has 1 to 25; nothing was done");
  for (int i = 0; i < RC_MAX_BATCH; ++i) Add(rcMOVE, RemoteRobot::JointValue(0, 0));
  EXPECT_EQ(Send(), rcOK);
  Add(rcMOVE, RemoteRobot::JointValue(0, 0));
  robot_.commands.clear();
  EXPECT_EQ(Send(), rcerrorBAD_VALUE);
  EXPECT_TRUE(robot_.commands.empty());
}

TEST_F(BatchTest, Version1DoesNotKnowIt) {
  Add(rcINFO, {});
  EXPECT_EQ(robot_.Ask(rcBATCH, batch_, RC_VERSION), rcerrorUNKNOWN_COMMAND);
}

TEST_F(BatchTest, ARequestAfterABatchIsAnsweredAsUsual) {
  Add(rcSHUTDOWN, {}, RC_VERSION_FILES);
  Add(rcINFO, {}, RC_VERSION);
  Answers();
  EXPECT_EQ(robot_.Ask(rcMTN_LIST, {0, 0}, RC_VERSION_FILES), rcOK) << robot_.error;
  EXPECT_EQ(robot_.version, RC_VERSION_FILES);
}

}  // namespace
}  // namespace openr_host
