// Streams of the remote control over TCP, with the real RCServer: packets that come unasked.
#include <gtest/gtest.h>

#include "RemoteStreams.h"
#include "tests/graph/graph.h"
#include "tests/graph/remote_packets.h"

namespace openr_host {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

std::string SubscribePacket(RcStream stream, int period, int tag) {
  return RcPacket(rcSUBSCRIBE,
                  RcBytes(RcSubscribe{static_cast<Uint8>(stream), static_cast<Uint16>(period)}),
                  tag);
}

// The values of an event; the head is left out.
template <typename Values>
Values ReadValues(const HeardPacket& packet) {
  HeardPacket values = packet;
  values.payload.erase(0, 4);
  return values.Read<Values>();
}

std::vector<HeardPacket> WithCommand(const std::vector<HeardPacket>& all, int command) {
  std::vector<HeardPacket> some;
  for (const HeardPacket& packet : all)
    if (packet.command == command) some.push_back(packet);
  return some;
}

// Runs for `vectors` periods of the sensor vectors; the client acknowledges events in each.
void RunAndTakeEvents(Graph* graph, openr::testing::TcpClient* client, int vectors) {
  for (int i = 0; i < vectors; ++i) {
    graph->RunFor(milliseconds(16));
    client->Send(RcPacket(rcEVENT));
    graph->RunFor(milliseconds(16));
  }
}

TEST(RemoteStreamsTest, SensorVectorsComeUnaskedBetweenAnswers) {
  Graph graph(kIdeal);
  graph.RunFor(seconds(1));
  auto& client = graph.AddClient();
  auto& other = graph.AddClient();
  other.Connect(RC_PORT);
  client.Connect(RC_PORT).Send(SubscribePacket(rcstreamSENSORS, 4, 42));
  for (int i = 0; i < 20; ++i) {
    RunAndTakeEvents(&graph, &client, 3);
    client.Send(RcPacket(rcINFO, "", 100 + i));
    other.Send(RcPacket(rcINFO, "", 100 + i));
  }
  RunAndTakeEvents(&graph, &client, 3);
  const auto heard = RcHeard(client.heard());
  const auto events = WithCommand(heard, rcEVENT);
  ASSERT_GT(events.size(), 55u);
  for (size_t i = 1; i < events.size(); ++i) {
    EXPECT_EQ(events[i].tag, 42);
    EXPECT_EQ(events[i].frame, events[i - 1].frame + 4) << "no vector is missed";
  }
  EXPECT_EQ(ReadValues<RcSensors>(events[0]).joints.size(), 18u);
  const auto answers = WithCommand(heard, rcINFO);
  ASSERT_EQ(answers.size(), 20u);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(answers[static_cast<size_t>(i)].tag, 100 + i);
  EXPECT_TRUE(WithCommand(RcHeard(other.heard()), rcEVENT).empty());
  EXPECT_EQ(WithCommand(RcHeard(other.heard()), rcINFO).size(), 20u);
  EXPECT_EQ(graph.Findings(), "");
}

TEST(RemoteStreamsTest, AMotionIsFollowedKeyFrameByKeyFrameToItsEnd) {
  WhenStanding(kIdeal, [](Graph& graph) {
    auto& client = graph.AddClient();
    client.Connect(RC_PORT)
        .Send(SubscribePacket(rcstreamSET_VALUES, 0, 7))
        .Send(RcPacket(rcMTN_PLAY, "\7BOW.MTN" + std::string("\1\0\0", 3), 8));
    RunAndTakeEvents(&graph, &client, 400);
    const auto heard = RcHeard(client.heard());
    const auto plays = WithCommand(heard, rcMTN_PLAY);
    ASSERT_EQ(plays.size(), 1u);
    ASSERT_EQ(plays[0].status, rcOK);
    const int key_frames = plays[0].Read<RcPlayAnswer>().keyFrames;
    std::vector<int> seen;
    bool is_over = false;
    for (const HeardPacket& event : WithCommand(heard, rcEVENT)) {
      EXPECT_EQ(event.payload[2], 0) << "none is left out";
      const auto values = ReadValues<RcSetValues>(event);
      is_over = values.isOver != 0;
      if (values.keyFrame >= 0) seen.push_back(values.keyFrame);
      if (values.keyFrame >= 0) {
        EXPECT_EQ(values.file, "BOW.MTN");
      }
    }
    EXPECT_TRUE(is_over);
    ASSERT_FALSE(seen.empty());
    EXPECT_EQ(seen.front(), 0);
    EXPECT_EQ(seen.back(), key_frames - 1);
  });
}

TEST(RemoteStreamsTest, AClientThatGoesEndsItsStreamsAndTheNextOneBeginsWithout) {
  Graph graph(kIdeal);
  graph.RunFor(seconds(1));
  for (const bool resets : {false, true}) {
    for (int i = 0; i < 9; ++i) {
      auto& client = graph.AddClient();
      client.Connect(RC_PORT).Send(SubscribePacket(rcstreamSENSORS, 4, 1));
      graph.RunFor(milliseconds(600));
      EXPECT_EQ(WithCommand(RcHeard(client.heard()), rcEVENT).size(), 3u);
      resets ? client.Reset() : client.Close();
      graph.RunFor(seconds(2));
    }
  }
  auto& last = graph.AddClient();
  last.Connect(RC_PORT).Send(RcPacket(rcINFO));
  graph.RunFor(seconds(1));
  EXPECT_EQ(RcHeard(last.heard()).size(), 1u);
}

// Vectors of sensors go on while the pieces of a request arrive.
TEST(RemoteStreamsTest, ARequestInPiecesIsAnsweredBetweenEvents) {
  Graph graph(kIdeal);
  graph.RunFor(seconds(1));
  auto& client = graph.AddClient();
  client.Connect(RC_PORT).Send(SubscribePacket(rcstreamSENSORS, 4, 1));
  for (const char byte : RcPacket(rcGET, std::string(1, 0), 5)) {
    client.Send(std::string(1, byte));
    graph.RunFor(milliseconds(40));
  }
  graph.RunFor(milliseconds(100));
  const auto answers = WithCommand(RcHeard(client.heard()), rcGET);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].tag, 5);
}

}  // namespace
}  // namespace openr_host
