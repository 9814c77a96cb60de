// Eight clients of the remote control, and the one more that connects (docs/remote-control.md).
#include <gtest/gtest.h>

#include <deque>

#include "RemoteProtocol.h"
#include "tests/graph/graph.h"

namespace openr_host {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

std::string InfoRequest() {
  uint8_t bytes[RC_MAX_PACKET];
  RcWriter out(bytes, RC_MAX_PACKET);
  for (int i = 0; i < RC_HEADER_SIZE; ++i) out.U8(0);
  out.PutHeader(rcINFO, 7);
  return {reinterpret_cast<char*>(bytes), static_cast<size_t>(out.Size())};
}

// Status and text of the last answer heard; -1: there is none.
struct Answer {
  int status = -1;
  int tag = -1;
  std::string text;
};
Answer LastAnswer(const openr::testing::TcpClient& client) {
  RcFramer framer;
  framer.Reset();
  framer.Append(reinterpret_cast<const Uint8*>(client.heard().data()),
                static_cast<int>(client.heard().size()));
  Answer answer;
  while (framer.Next() == RcFramer::PACKET) {
    RcAnswerHeader header;
    if (!header.Read(framer)) continue;
    answer.status = header.status;
    answer.tag = header.header.tag;
    const int begin = RC_ANSWER_HEADER_SIZE - RC_HEADER_SIZE;
    RcReader in(framer.Payload() + begin, framer.PayloadSize() - begin);
    if (header.status != rcOK) answer.text = in.String();
  }
  return answer;
}

class RemotePlacesTest : public testing::Test {
 protected:
  RemotePlacesTest() : graph(kIdeal) {
    graph.RunFor(seconds(1));
    for (int i = 0; i < 8; ++i) Connect();
  }

  openr::testing::TcpClient& Connect() {
    clients.push_back(&graph.AddClient());
    clients.back()->Connect(RC_PORT);
    graph.RunFor(milliseconds(100));
    EXPECT_TRUE(clients.back()->connected());
    return *clients.back();
  }
  void Talk(int first, int last) {
    for (int i = first; i <= last; ++i) clients[static_cast<size_t>(i)]->Send(InfoRequest());
    graph.RunFor(milliseconds(100));
  }
  int NumEnded() const {
    int count = 0;
    for (const openr::testing::TcpClient* client : clients) count += client->ended() ? 1 : 0;
    return count;
  }

  Graph graph;
  std::deque<openr::testing::TcpClient*> clients;
};

constexpr char kNoPlace[] =
    "all 8 places are taken, and none of these clients has been silent for 10 s; end one of them, "
    "or try again";

TEST_F(RemotePlacesTest, EightQuietClientsStayWhileNobodyWaits) {
  graph.RunFor(seconds(60));
  EXPECT_EQ(NumEnded(), 0);
  Talk(0, 7);
  for (const auto* client : clients) EXPECT_EQ(LastAnswer(*client).status, rcOK);
}

TEST_F(RemotePlacesTest, TheOneSilentLongestGivesWayToANinth) {
  graph.RunFor(seconds(11));
  Talk(0, 3);
  Talk(5, 7);
  auto& ninth = Connect();
  ninth.Send(InfoRequest());
  graph.RunFor(milliseconds(100));
  EXPECT_EQ(LastAnswer(ninth).status, rcOK);
  EXPECT_TRUE(clients[4]->ended());
  EXPECT_EQ(NumEnded(), 1);
  // All others were heard of a moment ago.  The place of the one that went is closed after 1 s.
  auto& tenth = Connect();
  tenth.Send(InfoRequest());
  graph.RunFor(seconds(2));
  EXPECT_EQ(LastAnswer(tenth).status, rcerrorBUSY);
}

TEST_F(RemotePlacesTest, ANinthIsToldThatThereIsNoPlace) {
  for (int i = 0; i < 3; ++i) {
    auto& more = Connect();
    more.Send(InfoRequest());
    graph.RunFor(milliseconds(200));
    const Answer answer = LastAnswer(more);
    EXPECT_EQ(answer.status, rcerrorBUSY);
    EXPECT_EQ(answer.tag, 7);
    EXPECT_EQ(answer.text, kNoPlace);
    EXPECT_TRUE(more.ended());
    more.Close();
    graph.RunFor(milliseconds(200));
  }
  EXPECT_EQ(NumEnded(), 3);
  Talk(0, 7);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(LastAnswer(*clients[static_cast<size_t>(i)]).status, rcOK);
}

TEST_F(RemotePlacesTest, ANinthThatSaysNothingIsAnsweredAsWell) {
  auto& ninth = Connect();
  for (int i = 0; i < 3; ++i) {
    Talk(0, 7);
    graph.RunFor(seconds(4));
  }
  EXPECT_EQ(LastAnswer(ninth).status, rcerrorBUSY);
  EXPECT_TRUE(ninth.ended());
  EXPECT_EQ(NumEnded(), 1);
}

TEST_F(RemotePlacesTest, APlaceThatGetsFreeIsThatOfTheOneWhoWaits) {
  auto& ninth = Connect();
  clients[2]->Close();
  graph.RunFor(milliseconds(200));
  ninth.Send(InfoRequest());
  graph.RunFor(milliseconds(200));
  EXPECT_EQ(LastAnswer(ninth).status, rcOK);
  EXPECT_FALSE(ninth.ended());
}

}  // namespace
}  // namespace openr_host
