// Tests of LoopbackNetwork itself, without a stack.
#include "runtime/ipstack/loopback_network.h"

#include <gtest/gtest.h>

namespace openr_host {
namespace {

using Kind = NetworkEvent::Kind;

class LoopbackNetworkTest : public testing::Test {
 protected:
  LoopbackNetworkTest() : a(hub), b(hub) {
    a.Attach(1);
    b.Attach(2);
  }
  // Connects handle 10 of host a with handle 20 of host b.
  void Connect() {
    b.Listen(1, 80);
    b.Accept(1, 20);
    a.Connect(10, 4000, {2, 80});
    a.Poll();
    b.Poll();
  }
  static std::vector<Kind> KindsOf(const std::vector<NetworkEvent>& events) {
    std::vector<Kind> kinds;
    for (const NetworkEvent& event : events) kinds.push_back(event.kind);
    return kinds;
  }

  std::shared_ptr<LoopbackHub> hub = std::make_shared<LoopbackHub>();
  LoopbackNetwork a, b;
};

TEST_F(LoopbackNetworkTest, NothingIsReportedTwice) {
  Connect();
  EXPECT_TRUE(a.Poll().empty());
  EXPECT_TRUE(b.Poll().empty());
}

TEST_F(LoopbackNetworkTest, ReceiveIsAnsweredOnceAndNotUnasked) {
  Connect();
  a.Send(10, "abc", 3);
  EXPECT_TRUE(b.Poll().empty());
  b.Receive(20, 2);
  const std::vector<NetworkEvent> events = b.Poll();
  ASSERT_EQ(KindsOf(events), std::vector<Kind>{Kind::kReceived});
  EXPECT_EQ(events[0].bytes, "ab");
  EXPECT_TRUE(b.Poll().empty());
}

TEST_F(LoopbackNetworkTest, SecondListenerOnAPortFails) {
  b.Listen(1, 80);
  b.Listen(2, 80);
  const std::vector<NetworkEvent> events = b.Poll();
  ASSERT_EQ(KindsOf(events), std::vector<Kind>{Kind::kFailed});
  EXPECT_EQ(events[0].error, NetError::kAddressInUse);
}

TEST_F(LoopbackNetworkTest, ConnectionsBeyondTheBacklogAreRefused) {
  b.Listen(1, 80);
  NetHandle handle = 10;
  for (size_t i = 0; i < LoopbackNetwork::kBacklog; ++i) a.Connect(handle++, 4000, {2, 80});
  EXPECT_EQ(a.Poll().back().kind, Kind::kConnected);
  a.Connect(handle, 4000, {2, 80});
  EXPECT_EQ(a.Poll().back().error, NetError::kRefused);
}

TEST_F(LoopbackNetworkTest, ClosingBothSidesClosesBoth) {
  Connect();
  a.Close(10);
  EXPECT_TRUE(a.Poll().empty());
  b.Receive(20, 10);
  EXPECT_EQ(KindsOf(b.Poll()), std::vector<Kind>{Kind::kEnd});
  b.Close(20);
  EXPECT_EQ(KindsOf(b.Poll()), std::vector<Kind>{Kind::kClosed});
  EXPECT_EQ(KindsOf(a.Poll()), std::vector<Kind>{Kind::kClosed});
}

TEST_F(LoopbackNetworkTest, WhatComesAfterCloseIsDiscardedWithoutPoll) {
  Connect();
  const std::string bytes(2 * LoopbackNetwork::kWindowBytes, 'x');
  b.Send(20, bytes.data(), bytes.size());
  size_t sent = b.Poll().at(0).count;
  EXPECT_EQ(sent, LoopbackNetwork::kWindowBytes);
  a.Close(10);
  sent += b.Poll().at(0).count;
  EXPECT_EQ(sent, bytes.size());
}

TEST_F(LoopbackNetworkTest, SendingToAPeerThatHasGoneIsAReset) {
  Connect();
  b.Drop(20, false);
  a.Send(10, "x", 1);
  EXPECT_EQ(a.Poll().back().error, NetError::kReset);
}

TEST_F(LoopbackNetworkTest, DropOfAListenerResetsWhoWaits) {
  b.Listen(1, 80);
  a.Connect(10, 4000, {2, 80});
  a.Poll();
  b.Drop(1, false);
  EXPECT_EQ(a.Poll().back().error, NetError::kReset);
}

TEST_F(LoopbackNetworkTest, NothingIsHeardOfADroppedHandle) {
  b.Listen(1, 80);
  a.Connect(10, 4000, {2, 80});
  a.Drop(10, true);
  EXPECT_TRUE(a.Poll().empty());
}

TEST_F(LoopbackNetworkTest, DatagramsBeyondTheQueueAreLost) {
  b.Bind(1, 99, false);
  a.Bind(1, 98, false);
  for (size_t i = 0; i < LoopbackNetwork::kDatagrams + 5; ++i) a.SendTo(1, {2, 99}, "x", 1);
  size_t count = 0;
  for (;;) {
    b.ReceiveFrom(1, 10);
    const size_t more = b.Poll().size();
    EXPECT_LE(more, 10u);
    count += more;
    if (more == 0) break;
  }
  EXPECT_EQ(count, LoopbackNetwork::kDatagrams);
}

TEST_F(LoopbackNetworkTest, HostWithANewAddressIsNotFoundAtTheOldOne) {
  b.Attach(3);
  b.Listen(1, 80);
  a.Connect(10, 4000, {2, 80});
  EXPECT_EQ(a.Poll().back().error, NetError::kHostUnreachable);
  a.Connect(11, 4001, {3, 80});
  EXPECT_EQ(KindsOf(a.Poll()), std::vector<Kind>{Kind::kConnected});
}

TEST_F(LoopbackNetworkTest, HostThatIsGoneIsUnreachableAndBreaksItsConnections) {
  {
    LoopbackNetwork c(hub);
    c.Attach(3);
    c.Listen(1, 80);
    c.Accept(1, 5);
    a.Connect(10, 4000, {3, 80});
    a.Poll();
    c.Poll();
  }
  EXPECT_EQ(a.Poll().back().error, NetError::kReset);
  a.Connect(11, 4000, {3, 80});
  EXPECT_EQ(a.Poll().back().error, NetError::kHostUnreachable);
}

}  // namespace
}  // namespace openr_host
