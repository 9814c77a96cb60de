#include "openr/ros2/joint_client.h"

#include <gmock/gmock.h>

#include <utility>

#include "RemoteProtocol.h"
#include "openr/inspect/recorded_network.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;
using Kind = NetworkEvent::Kind;

constexpr NetHandle kListener = 1;
constexpr NetHandle kFirst = 2;
constexpr NetHandle kSecond = 3;

// Counts the calls of Forget().
class ForgettingNetwork : public ReplayedNetwork {
 public:
  ForgettingNetwork(NextEvents next_events, int* count)
      : ReplayedNetwork(std::move(next_events)), count_(*count) {}
  void Forget() override { ++count_; }

 private:
  int& count_;
};

class JointClientTest : public testing::Test {
 protected:
  JointClientTest()
      : client_(std::make_unique<ForgettingNetwork>([this] { return std::exchange(outside_, {}); },
                                                    &forgotten_),
                [this](const std::string& why) { refusals_.push_back(why); }) {
    client_.Listen(kListener, RC_PORT);
    client_.Accept(kListener, kFirst);
    client_.Accept(kListener, kSecond);
  }

  // Returns all that the robot reads at the next frame.
  std::string Read(NetHandle handle) {
    client_.Receive(handle, 4096);
    for (const NetworkEvent& event : client_.Poll()) {
      if (event.kind == Kind::kReceived && event.handle == handle) return event.bytes;
    }
    return "";
  }

  // Lets the robot answer one request.
  void Answer(NetHandle handle, int status, const std::string& text = "") {
    uint8_t bytes[RC_MAX_PACKET];
    RcWriter writer(bytes, sizeof bytes);
    const auto payload = static_cast<Uint32>(text.empty() ? 0 : text.size() + 1);
    writer.U16(RC_MAGIC);
    writer.U16(RC_ANSWER_HEADER_SIZE + payload);
    writer.U8(RC_VERSION);
    writer.U8(rcMOVE);
    writer.U16(0);
    writer.U32(7);
    writer.U16(static_cast<Uint32>(status));
    writer.U16(0);
    if (!text.empty()) writer.String(text);
    client_.Send(handle, bytes, static_cast<size_t>(writer.Size()));
  }

  std::vector<NetworkEvent> outside_;  // events for the next Poll()
  std::vector<std::string> refusals_;
  int forgotten_ = 0;
  JointClient client_;
};

// Makes a packet with one joint and one value in 0.01 degree.
std::string Packet(int command, int joint, int value) {
  std::string bytes = {
      'R', 'C', 13, 0, 1, static_cast<char>(command), 0, 0, static_cast<char>(joint)};
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
  return bytes;
}

TEST_F(JointClientTest, WithoutACommandThereIsNoConnection) {
  EXPECT_TRUE(client_.Poll().empty());
  EXPECT_FALSE(client_.IsWaiting());
}

TEST_F(JointClientTest, ACommandConnectsAndComesAsPackets) {
  client_.SetTargets({{1, {0.5, 2}}, {4, {-0.1, 0}}});
  const std::vector<NetworkEvent> events = client_.Poll();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, Kind::kAccepted);
  EXPECT_EQ(events[0].handle, kFirst);
  EXPECT_EQ(Read(kFirst),
            Packet(rcSPEED, 1, 11459) + Packet(rcMOVE, 1, 2865) + Packet(rcMOVE, 4, -573));
  EXPECT_FALSE(client_.IsWaiting());
}

TEST_F(JointClientTest, APlaceThatSomebodyElseHasTakenIsNotUsed) {
  NetworkEvent accepted;
  accepted.kind = Kind::kAccepted;
  accepted.handle = kFirst;
  outside_ = {accepted};
  client_.SetTargets({{1, {0.5, 0}}});
  const std::vector<NetworkEvent> events = client_.Poll();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[1].handle, kSecond);
}

TEST_F(JointClientTest, TheNewestOfEachJointWaitsForTheAnswer) {
  client_.SetTargets({{1, {0.1, 0}}});
  client_.Poll();
  EXPECT_EQ(Read(kFirst), Packet(rcMOVE, 1, 573));
  client_.SetTargets({{1, {0.2, 0}}, {2, {0.2, 0}}});
  client_.SetTargets({{1, {0.3, 0}}});
  EXPECT_EQ(Read(kFirst), "");
  EXPECT_TRUE(client_.IsWaiting());
  Answer(kFirst, rcOK);
  EXPECT_EQ(Read(kFirst), Packet(rcMOVE, 1, 1719) + Packet(rcMOVE, 2, 1146));
  EXPECT_TRUE(refusals_.empty());
}

TEST_F(JointClientTest, ASpeedHoldsForWhatComesAfterIt) {
  client_.SetTargets({{1, {0.1, 2.0}}});
  client_.SetTargets({{1, {0.2, 0}}});
  client_.Poll();
  EXPECT_EQ(Read(kFirst), Packet(rcSPEED, 1, 11459) + Packet(rcMOVE, 1, 1146));
}

TEST_F(JointClientTest, AnAbandonedCommandIsNotSentLater) {
  client_.SetTargets({{1, {0.1, 0}}});
  client_.Poll();
  EXPECT_EQ(Read(kFirst), Packet(rcMOVE, 1, 573));
  client_.SetTargets({{1, {0.2, 0}}});
  client_.GiveUp();
  EXPECT_FALSE(client_.IsWaiting());
  Answer(kFirst, rcOK);
  EXPECT_EQ(Read(kFirst), "");
}

TEST_F(JointClientTest, BytesOfAnswersAreTaken) {
  client_.SetTargets({{1, {0.1, 0}}});
  client_.Poll();
  Answer(kFirst, rcOK);
  const std::vector<NetworkEvent> events = client_.Poll();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, Kind::kSent);
  EXPECT_EQ(events[0].count, uint64_t{RC_ANSWER_HEADER_SIZE});
}

TEST_F(JointClientTest, ReadsMayBeSmall) {
  client_.SetTargets({{1, {0.1, 0}}});
  client_.Poll();
  std::string read;
  for (int i = 0; i < 5; ++i) {
    client_.Receive(kFirst, 3);
    for (const NetworkEvent& event : client_.Poll()) read += event.bytes;
  }
  EXPECT_EQ(read, Packet(rcMOVE, 1, 573));
}

TEST_F(JointClientTest, ARefusalIsHeard) {
  client_.SetTargets({{1, {0.1, 0}}});
  client_.Poll();
  Answer(kFirst, rcerrorBUSY, "a motion plays");
  EXPECT_THAT(refusals_, ElementsAre("a motion plays"));
}

TEST_F(JointClientTest, AnInvalidAnswerEndsTheConnection) {
  client_.SetTargets({{1, {0.1, 0}}});
  client_.Poll();
  client_.Receive(kFirst, 100);
  client_.Send(kFirst, "220 ftp ready\r\n", 15);
  EXPECT_EQ(refusals_.size(), 1u);
  const std::vector<NetworkEvent> events = client_.Poll();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[1].kind, Kind::kEnd);
}

TEST_F(JointClientTest, AfterTheRobotHasClosedItConnectsAnew) {
  client_.SetTargets({{1, {0.1, 0}}});
  client_.Poll();
  client_.Close(kFirst);
  const std::vector<NetworkEvent> closed = client_.Poll();
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_EQ(closed[0].kind, Kind::kClosed);
  client_.Drop(kFirst, false);
  client_.SetTargets({{1, {0.2, 0}}});
  client_.Poll();
  EXPECT_EQ(Read(kSecond), Packet(rcMOVE, 1, 1146));
}

TEST_F(JointClientTest, AForkForgetsTheSocketsOfTheHost) {
  client_.SetTargets({{1, {0.1, 0}}});
  client_.Poll();
  EXPECT_EQ(forgotten_, 0);
  client_.Forget();
  EXPECT_EQ(forgotten_, 1);
  client_.SetTargets({{1, {0.1, 0}}});
  EXPECT_TRUE(client_.Poll().empty());  // no Accept() waits any more
}

TEST_F(JointClientTest, PositionsBeyondAllJointsAreCut) {
  client_.SetTargets({{1, {1e300, 1e300}}});
  client_.Poll();
  EXPECT_EQ(Read(kFirst), Packet(rcSPEED, 1, 5729578) + Packet(rcMOVE, 1, 36000));
}

}  // namespace
}  // namespace openr_host
