// UDP operations; numbers in answers are those of UDPEndpointError.
#include "runtime/ipstack/udp_endpoint.h"

#include "tests/runtime/ipstack/net_probe.h"

namespace openr_host {
namespace {

class UdpTest : public NetTest {
 protected:
  UdpTest() {
    peer.net.Bind(Peer::kUdp, 9999, false);
    Do([this] {
      endpoint = probe->NewEndpoint(EndpointType_UDP);
      buffer = probe->NewBuffer(70000);
    });
  }
  void Bind(uint16_t port) {
    Do([=, this] { probe->Send(UDPEndpointBindMsg(endpoint, IP_ADDR_ANY, port)); });
    EXPECT_EQ(TakeReplies(), Replies{"UDP Bind 0"});
  }
  void Receive(int size) {
    Do([=, this] { probe->Send(UDPEndpointReceiveMsg(endpoint, buffer, size)); });
  }
  void SendTo(uint32_t ip, uint16_t port, const std::string& text) {
    Do([=, this] {
      std::memcpy(buffer, text.data(), text.size());
      probe->Send(UDPEndpointSendMsg(endpoint, ip, port, buffer, static_cast<int>(text.size())));
    });
  }
  void PeerSays(const std::string& text) {
    peer.net.SendTo(Peer::kUdp, {kRobotIp, kPort}, text.data(), text.size());
  }

  antModuleRef endpoint;
  byte* buffer = nullptr;
};

TEST_F(UdpTest, BindAnswersWithAddressAndChosenPort) {
  probe->on_reply = [](antEnvMsg* m) {
    const auto& bind = *static_cast<UDPEndpointBindMsg*>(m);
    EXPECT_EQ(bind.address, IPAddress(kRobotIp));
    EXPECT_GE(bind.port, 1024);
  };
  Bind(IP_PORT_ANY);
}

TEST_F(UdpTest, SecondBindOfAPortIsAddressInUseAndOfAnEndpointInvalid) {
  Bind(kPort);
  Do([&] {
    antModuleRef second = probe->NewEndpoint(EndpointType_UDP);
    probe->Send(UDPEndpointBindMsg(second, IP_ADDR_ANY, kPort));
    probe->Send(UDPEndpointBindMsg(endpoint, IP_ADDR_ANY, 1));
    probe->Send(UDPEndpointBindMsg(second, kClientIp, 2));
  });
  EXPECT_EQ(probe->replies, (Replies{"UDP Bind 4", "UDP Bind 14", "UDP Bind 5"}));
}

TEST_F(UdpTest, PortIsFreeAgainAfterClose) {
  Bind(kPort);
  Do([&] {
    probe->Send(UDPEndpointCloseMsg(endpoint));
    antModuleRef second = probe->NewEndpoint(EndpointType_UDP);
    probe->Send(UDPEndpointBindMsg(second, IP_ADDR_ANY, kPort));
  });
  EXPECT_EQ(probe->replies, (Replies{"UDP Close 0", "UDP Bind 0"}));
}

TEST_F(UdpTest, TransferBeforeBindIsInvalid) {
  SendTo(kClientIp, 9999, "x");
  Receive(10);
  EXPECT_EQ(probe->replies, (Replies{"UDP Send 14", "UDP Receive 14"}));
}

TEST_F(UdpTest, ReceiveTellsTheOriginAndEchoReachesIt) {
  Bind(kPort);
  Receive(100);
  probe->on_reply = [&](antEnvMsg* m) {
    if (m->GetOperation() != UDPEndpoint_Operation_Receive) return;
    const auto& got = *static_cast<UDPEndpointReceiveMsg*>(m);
    EXPECT_EQ(got.address, IPAddress(kClientIp));
    EXPECT_EQ(got.port, 9999);
    probe->Send(UDPEndpointSendMsg(endpoint, got.address, got.port, got.buffer, got.size));
  };
  PeerSays("hello");
  Frames();
  peer.net.ReceiveFrom(Peer::kUdp, 100);
  Frames();
  EXPECT_EQ(probe->replies, (Replies{"UDP Receive 0 'hello'", "UDP Send 0"}));
  ASSERT_EQ(peer.datagrams.size(), 1u);
  EXPECT_EQ(peer.datagrams[0].bytes, "hello");
  EXPECT_EQ(peer.datagrams[0].remote, (NetAddress{kRobotIp, kPort}));
}

TEST_F(UdpTest, WhatDoesNotFitIsDropped) {
  Bind(kPort);
  PeerSays("abcdef");
  PeerSays("ghi");
  Receive(4);
  Frames();
  Receive(4);
  Frames();
  EXPECT_EQ(probe->replies, (Replies{"UDP Receive 0 'abcd'", "UDP Receive 0 'ghi'"}));
}

TEST_F(UdpTest, DatagramsOfOneFrameAreDeliveredAtOneInstant) {
  Bind(kPort);
  for (const char* text : {"a", "b", "c"}) PeerSays(text);
  probe->on_reply = [&](antEnvMsg*) { probe->Send(UDPEndpointReceiveMsg(endpoint, buffer, 10)); };
  Receive(10);
  Frames();
  EXPECT_EQ(probe->replies,
            (Replies{"UDP Receive 0 'a'", "UDP Receive 0 'b'", "UDP Receive 0 'c'"}));
}

TEST_F(UdpTest, SecondReceiveIsBusy) {
  Bind(kPort);
  Receive(10);
  Receive(10);
  EXPECT_EQ(probe->replies, Replies{"UDP Receive 3"});
}

TEST_F(UdpTest, SendsBeyondThePoolWaitForTheNextFrame) {
  Bind(kPort);
  const std::string half(3000, 'x');
  SendTo(kClientIp, 9999, half);
  SendTo(kClientIp, 9999, half);  // the pool has 4096 bytes
  SendTo(kClientIp, 9999, half);
  EXPECT_EQ(TakeReplies(), (Replies{"UDP Send 0", "UDP Send 3"}));
  Frames();
  EXPECT_EQ(probe->replies, Replies{"UDP Send 0"});
}

TEST_F(UdpTest, SendsThatCannotBeAreRefused) {
  Bind(kPort);
  Do([&] {
    antModuleRef big = probe->NewEndpoint(EndpointType_UDP, 100'000);
    probe->Send(UDPEndpointBindMsg(big, IP_ADDR_ANY, IP_PORT_ANY));
    probe->Send(UDPEndpointSendMsg(big, kClientIp, 9999, buffer, UdpEndpoint::kDatagramMax + 1));
    probe->Send(UDPEndpointSendMsg(endpoint, kClientIp, 9999, buffer, 4097));  // more than the pool
    probe->Send(UDPEndpointSendMsg(endpoint, buffer, 1));                      // no destination
    probe->Send(UDPEndpointSendMsg(endpoint, IP_ADDR_BROADCAST, 9, buffer, 1));
    probe->Send(UDPEndpointSendMsg(endpoint, kClientIp, 9999, buffer, 0));
    probe->Send(UDPEndpointReceiveMsg(endpoint, buffer, 80'000));
  });
  EXPECT_EQ(probe->replies, (Replies{"UDP Bind 0", "UDP Send 10", "UDP Send 1", "UDP Send 5",
                                     "UDP Send 5", "UDP Send 13", "UDP Receive 13"}));
}

TEST_F(UdpTest, ConnectedEndpointSendsWithoutAnAddressAndHearsOnlyItsPeer) {
  Bind(kPort);
  peer.net.Bind(3, 8888, false);
  Do([&] { probe->Send(UDPEndpointConnectMsg(endpoint, kClientIp, 9999)); });
  Receive(10);
  peer.net.SendTo(3, {kRobotIp, kPort}, "stranger", 8);
  Frames();
  PeerSays("friend");
  Frames();
  EXPECT_EQ(TakeReplies(), (Replies{"UDP Connect 0", "UDP Receive 0 'friend'"}));
  peer.net.ReceiveFrom(Peer::kUdp, 100);
  Do([&] { probe->Send(UDPEndpointSendMsg(endpoint, buffer, 6)); });
  Frames();
  ASSERT_EQ(peer.datagrams.size(), 1u);
  EXPECT_EQ(peer.datagrams[0].bytes, "friend");
}

TEST_F(UdpTest, ConnectedToLoopbackItHearsItsOwnRobot) {
  Bind(kPort);
  Do([&] { probe->Send(UDPEndpointConnectMsg(endpoint, 0x7f000001, 9000)); });
  Receive(10);
  Do([&] {
    antModuleRef other = probe->NewEndpoint(EndpointType_UDP);
    probe->Send(UDPEndpointBindMsg(other, IP_ADDR_ANY, 9000));
    std::memcpy(buffer + 100, "echo", 4);
    probe->Send(UDPEndpointSendMsg(other, 0x7f000001, kPort, buffer + 100, 4));
  });
  Frames(2);
  EXPECT_EQ(probe->replies.back(), "UDP Receive 0 'echo'");
}

TEST_F(UdpTest, ResetConnectHearsEverybodyAgain) {
  Bind(kPort);
  Do([&] {
    probe->Send(UDPEndpointConnectMsg(endpoint, kClientIp, 1));
    probe->Send(UDPEndpointResetConnectMsg(endpoint));
  });
  Receive(10);
  PeerSays("x");
  Frames();
  EXPECT_EQ(probe->replies.back(), "UDP Receive 0 'x'");
}

TEST_F(UdpTest, CloseAnswersThePendingReceiveFirst) {
  Bind(kPort);
  Receive(10);
  Do([&] {
    UDPEndpointCloseMsg close(endpoint);
    EXPECT_EQ(close.Call(probe->Stack(), sizeof close), ANT_SUCCESS);
    EXPECT_EQ(close.error, UDP_SUCCESS);
  });
  Receive(10);
  EXPECT_EQ(probe->replies, (Replies{"UDP Receive 2", "UDP Receive 2"}));
}

TEST_F(UdpTest, AddressTellsBothEnds) {
  Bind(kPort);
  probe->on_reply = [](antEnvMsg* m) {
    EXPECT_EQ(static_cast<UDPEndpointAddressMsg*>(m)->lPort, kPort);
  };
  Do([&] { probe->Send(UDPEndpointAddressMsg(endpoint)); });
  EXPECT_EQ(probe->replies, Replies{"UDP Address 0"});
}

// The programs UDPEchoServer and NTP give the size of another, larger struct.
TEST_F(UdpTest, MessageSizeIsNotTrusted) {
  Do([&] {
    UDPEndpointBindMsg bind(endpoint, IP_ADDR_ANY, kPort);
    EXPECT_EQ(bind.Call(probe->Stack(), 100'000), ANT_SUCCESS);
    EXPECT_EQ(bind.error, UDP_SUCCESS);
    EXPECT_EQ(bind.msgSize, 100'000);
  });
}

}  // namespace
}  // namespace openr_host
