// The connection of a client without its network: answers and streams.
#include <gtest/gtest.h>

#include "ClientSession.h"
#include "remote_robot.h"

namespace openr_host {
namespace {

using Bytes = std::vector<uint8_t>;

struct SentPacket {
  RcAnswerHeader head;
  Bytes payload;
};

class ClientSessionTest : public testing::Test {
 protected:
  ClientSessionTest() { session_.Begin(0, &robot_.handler); }

  void Receive(const Bytes& bytes) {
    session_.Receive(bytes.data(), static_cast<int>(bytes.size()));
  }
  void Ask(int command, const Bytes& payload, int tag = 1) {
    Receive(RemoteRobot::Packet(command, payload, RC_VERSION_FILES, tag));
  }
  void Subscribe(RcStream stream, uint8_t period, int tag = 9) {
    Ask(rcSUBSCRIBE, {static_cast<uint8_t>(stream), period, 0}, tag);
    const auto answer = Answers();
    ASSERT_EQ(answer.size(), 1u);
    ASSERT_EQ(answer[0].head.status, rcOK);
  }
  // A sensor vector whose last frame is `frame`.
  void Vector(uint32_t frame) {
    SensorValues values = {};
    values.frame = frame;
    values.joint[0] = static_cast<Sint32>(frame % 100) * 17453;
    robot_.handler.SetSensors(values);
  }

  std::vector<SentPacket> Answers() { return Packets(session_.NextAnswers(buffer_)); }
  // Returns the events that are due, and takes them.
  std::vector<SentPacket> Events() {
    const auto events = EventsNotTaken();
    Ask(rcEVENT, {});
    EXPECT_TRUE(Answers().empty()) << "an acknowledgement has no answer";
    return events;
  }
  std::vector<SentPacket> EventsNotTaken() { return Packets(session_.NextEvents(buffer_)); }
  std::vector<SentPacket> Packets(int size) {
    EXPECT_LE(size, RC_MAX_PACKET);
    std::vector<SentPacket> packets;
    RcFramer framer;
    framer.Append(buffer_, size);
    while (framer.Next() == RcFramer::PACKET) {
      SentPacket packet;
      EXPECT_TRUE(packet.head.Read(framer));
      packet.payload.assign(framer.Payload() + 8, framer.Payload() + framer.PayloadSize());
      packets.push_back(packet);
    }
    return packets;
  }
  // The values of an event, and how many were left out before it.
  template <typename Values>
  Values ReadEvent(const SentPacket& packet, int* left_out) {
    EXPECT_EQ(packet.head.header.command, rcEVENT);
    RcReader in(packet.payload.data(), static_cast<int>(packet.payload.size()));
    RcEventHead head;
    head.Read(&in);
    *left_out = head.leftOut;
    Values values{};
    EXPECT_TRUE(values.Read(&in));
    return values;
  }

  RemoteRobot robot_;
  ClientSession session_;
  uint8_t buffer_[ClientSession::SEND_SIZE];
};

TEST_F(ClientSessionTest, BytesMayArriveOneByOne) {
  for (const uint8_t byte : RemoteRobot::Packet(rcINFO, {})) {
    EXPECT_TRUE(Answers().empty());
    Receive({byte});
  }
  EXPECT_EQ(Answers().size(), 1u);
  EXPECT_TRUE(Answers().empty());
}

TEST_F(ClientSessionTest, AnAnswerWithoutRoomGoesOutInTheNextSend) {
  Ask(rcINFO, {}, 1);
  Bytes batch;
  for (int i = 0; i < 6; ++i) {
    const Bytes part = RemoteRobot::Packet(rcSENSORS, {});
    batch.insert(batch.end(), part.begin(), part.end());
  }
  Ask(rcBATCH, batch, 2);
  Ask(rcGET, {0}, 3);
  auto sent = Answers();
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].head.header.tag, 1);
  sent = Answers();
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].head.header.tag, 2);
  sent = Answers();
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].head.header.tag, 3);
}

TEST_F(ClientSessionTest, BytesThatAreNoPacketEndTheSession) {
  Ask(rcINFO, {});
  Receive({'H', 'T', 'T', 'P'});
  const auto sent = Answers();
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_EQ(sent[1].head.status, rcerrorBAD_PACKET);
  EXPECT_TRUE(session_.IsLast());
  EXPECT_NE(session_.Error(), "");
  EXPECT_TRUE(Answers().empty());
}

TEST_F(ClientSessionTest, AClientWithoutAPlaceGetsOneAnswer) {
  session_.SetWaiting(true);
  Ask(rcINFO, {}, 1);
  Ask(rcINFO, {}, 2);
  const auto sent = Answers();
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].head.status, rcerrorBUSY);
  EXPECT_TRUE(session_.IsLast());
  EXPECT_TRUE(Answers().empty());
}

TEST_F(ClientSessionTest, NothingIsAnsweredAfterTheEndOfTheRun) {
  Ask(rcSHUTDOWN, {}, 1);
  Ask(rcINFO, {}, 2);
  EXPECT_EQ(Answers().size(), 1u);
  EXPECT_TRUE(session_.IsLast());
  EXPECT_TRUE(session_.EndsRun());
}

TEST_F(ClientSessionTest, WithoutASubscriptionNothingComesUnasked) {
  Vector(2503);
  robot_.Say(moverMTN, 1);
  EXPECT_FALSE(robot_.handler.HasEvents(0));
  EXPECT_TRUE(Events().empty());
}

TEST_F(ClientSessionTest, SensorValuesComeEveryPeriodWithTheTagOfTheRequest) {
  Subscribe(rcstreamSENSORS, 8, 77);
  EXPECT_TRUE(Events().empty()) << "no vector has come since";
  std::vector<uint32_t> frames;
  for (uint32_t frame = 2503; frame < 2540; frame += 4) {
    Vector(frame);
    for (const SentPacket& packet : Events()) {
      int left_out = -1;
      const auto sensors = ReadEvent<RcSensors>(packet, &left_out);
      EXPECT_EQ(sensors.joints[0], static_cast<Sint32>(frame % 100) * 100);
      EXPECT_EQ(left_out, 0);
      EXPECT_EQ(packet.head.header.tag, 77);
      EXPECT_EQ(packet.head.header.version, RC_VERSION_FILES);
      frames.push_back(packet.head.frame);
    }
  }
  EXPECT_EQ(frames, (std::vector<uint32_t>{2503, 2511, 2519, 2527, 2535}));
}

TEST_F(ClientSessionTest, AClientThatDoesNotTakeThemGetsTheNewestAndHowManyWereLeftOut) {
  Subscribe(rcstreamSENSORS, 4);
  for (uint32_t frame = 2503; frame <= 2543; frame += 4) Vector(frame);
  const auto events = Events();
  ASSERT_EQ(events.size(), 1u);
  int left_out = 0;
  EXPECT_EQ(ReadEvent<RcSensors>(events[0], &left_out).joints[0], 4300);
  EXPECT_EQ(left_out, 10);
  EXPECT_TRUE(Events().empty());
}

TEST_F(ClientSessionTest, AClientThatSaysNothingGetsEventsEvery224Milliseconds) {
  Subscribe(rcstreamSENSORS, 4);
  std::vector<uint32_t> frames;
  for (uint32_t frame = 2503; frame < 2600; frame += 4) {
    Vector(frame);
    for (const SentPacket& packet : EventsNotTaken()) frames.push_back(packet.head.frame);
  }
  EXPECT_EQ(frames, (std::vector<uint32_t>{2503, 2531, 2559, 2587}));
}

TEST_F(ClientSessionTest, AnyBytesOfTheClientLetEventsCome) {
  Subscribe(rcstreamSENSORS, 4);
  Vector(2503);
  EXPECT_EQ(EventsNotTaken().size(), 1u);
  Vector(2507);
  EXPECT_TRUE(EventsNotTaken().empty());
  Receive({'R'});
  EXPECT_EQ(EventsNotTaken().size(), 1u);
}

TEST_F(ClientSessionTest, InVersion1AnAcknowledgementIsAnUnknownCommand) {
  Receive(RemoteRobot::Packet(rcEVENT, {}, RC_VERSION));
  const auto answers = Answers();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].head.status, rcerrorUNKNOWN_COMMAND);
}

TEST_F(ClientSessionTest, AfterALateEventTheNextOneIsAPeriodLater) {
  Subscribe(rcstreamSENSORS, 12);
  Vector(2503);
  Vector(2507);
  EXPECT_EQ(Events().size(), 1u);
  Vector(2515);
  EXPECT_TRUE(Events().empty());
  Vector(2519);
  EXPECT_EQ(Events().size(), 1u);
}

TEST_F(ClientSessionTest, EveryKeyFrameIsReported) {
  Subscribe(rcstreamSET_VALUES, 0);
  for (const int key_frame : {0, 2, 4, -1}) {
    robot_.Say(key_frame < 0 ? moverACCEPTING_COMMANDS : moverMTN, key_frame);
    const auto events = Events();
    ASSERT_EQ(events.size(), 1u);
    int left_out = -1;
    const auto values = ReadEvent<RcSetValues>(events[0], &left_out);
    EXPECT_EQ(values.keyFrame, key_frame);
    EXPECT_EQ(values.commanded.size(), 18u);
    EXPECT_EQ(values.measured.size(), 18u);
    EXPECT_EQ(left_out, 0);
  }
}

TEST_F(ClientSessionTest, KeyFramesWithinThePeriodWaitAndTheNewestIsSent) {
  Subscribe(rcstreamSET_VALUES, 4);
  robot_.Say(moverMTN, 1);
  EXPECT_EQ(Events().size(), 1u);
  robot_.Say(moverMTN, 2);
  robot_.Say(moverMTN, 3);
  EXPECT_TRUE(Events().empty());
  Vector(2504);
  const auto events = Events();
  ASSERT_EQ(events.size(), 1u);
  int left_out = 0;
  EXPECT_EQ(ReadEvent<RcSetValues>(events[0], &left_out).keyFrame, 3);
  EXPECT_EQ(left_out, 1);
}

TEST_F(ClientSessionTest, BothStreamsFitIntoOneSend) {
  Subscribe(rcstreamSENSORS, 4, 1);
  Subscribe(rcstreamSET_VALUES, 0, 2);
  Vector(2503);
  robot_.Say(moverMTN, 1);
  EXPECT_EQ(Events().size(), 2u);
}

TEST_F(ClientSessionTest, AnswersGoBeforeEvents) {
  Subscribe(rcstreamSENSORS, 4);
  Vector(2503);
  Ask(rcINFO, {});
  const auto answers = Answers();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].head.header.command, rcINFO);
  EXPECT_EQ(Events().size(), 1u);
}

TEST_F(ClientSessionTest, AStreamEndsWithUnsubscribeOrItsClient) {
  Subscribe(rcstreamSENSORS, 4);
  Vector(2503);
  Ask(rcUNSUBSCRIBE, {rcstreamSENSORS});
  EXPECT_EQ(Answers().size(), 1u);
  EXPECT_TRUE(Events().empty());
  Subscribe(rcstreamSENSORS, 4);
  session_.End();
  Vector(2507);
  EXPECT_FALSE(robot_.handler.HasEvents(0));
}

TEST_F(ClientSessionTest, ASecondSubscriptionReplacesTheFirst) {
  Subscribe(rcstreamSENSORS, 4, 1);
  Subscribe(rcstreamSENSORS, 100, 2);
  Vector(2503);
  auto events = Events();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].head.header.tag, 2);
  Vector(2507);
  EXPECT_TRUE(Events().empty());
}

TEST_F(ClientSessionTest, AFrameNumberThatBeginsAnewEndsNoStream) {
  Subscribe(rcstreamSENSORS, 4);
  Vector(0x0ffffff3);
  EXPECT_EQ(Events().size(), 1u);
  Vector(6);
  EXPECT_EQ(Events().size(), 1u);
  Vector(10);
  EXPECT_EQ(Events().size(), 1u);
}

TEST_F(ClientSessionTest, SubscriptionsThatMakeNoSenseAreRefused) {
  const auto refusal = [&](int command, const Bytes& payload) {
    const int status = robot_.Ask(command, payload, RC_VERSION_FILES);
    EXPECT_FALSE(robot_.handler.HasEvents(0));
    return status;
  };
  EXPECT_EQ(refusal(rcSUBSCRIBE, {2, 4, 0}), rcerrorBAD_VALUE);
  EXPECT_EQ(robot_.error, "stream 2 is unknown; 0 is sensor values, 1 is set values");
  EXPECT_EQ(refusal(rcSUBSCRIBE, {0, 6, 0}), rcerrorBAD_VALUE);
  EXPECT_EQ(robot_.error, "period of 6 frames, must be a multiple of 4 from 4 on");
  EXPECT_EQ(refusal(rcSUBSCRIBE, {0, 0, 0}), rcerrorBAD_VALUE);
  EXPECT_EQ(refusal(rcSUBSCRIBE, {0, 4}), rcerrorMALFORMED);
  EXPECT_EQ(refusal(rcUNSUBSCRIBE, {2}), rcerrorBAD_VALUE);
  EXPECT_EQ(refusal(rcUNSUBSCRIBE, {}), rcerrorMALFORMED);
  EXPECT_EQ(refusal(rcUNSUBSCRIBE, {1}), rcOK) << "there was none";
  EXPECT_EQ(refusal(rcEVENT, {}), rcerrorUNKNOWN_COMMAND);
  EXPECT_EQ(robot_.Ask(rcSUBSCRIBE, {0, 4, 0}, RC_VERSION), rcerrorUNKNOWN_COMMAND);
}

}  // namespace
}  // namespace openr_host
