// Tests of the end of connections.
#include "runtime/ipstack/tcp_endpoint.h"
#include "tests/runtime/ipstack/net_probe.h"

namespace openr_host {
namespace {

using TcpCloseTest = ConnectedTest;

TEST_F(TcpCloseTest, CloseIsAnsweredWhenThePeerHasEndedToo) {
  Close();
  Frames(3);
  EXPECT_TRUE(peer.ended);
  EXPECT_TRUE(probe->replies.empty());
  peer.net.Close(peer.handle);
  Frames();
  EXPECT_EQ(probe->replies, Replies{"TCP Close 0"});
}

TEST_F(TcpCloseTest, CloseDoesNotWaitForeverForThePeer) {
  Close();
  system.RunFor(1'100'000);
  EXPECT_EQ(probe->replies, Replies{"TCP Close 0"});
}

TEST_F(TcpCloseTest, WhatWasSentBeforeCloseArrives) {
  Send("goodbye");
  Close();
  Frames();
  EXPECT_EQ(peer.heard, "goodbye");
  Frames();
  EXPECT_TRUE(peer.ended);
}

TEST_F(TcpCloseTest, AfterPassiveCloseTheApplicationsCloseIsAnswered) {
  peer.net.Close(peer.handle);
  Receive(1, 10);
  Frames();
  Close();
  Frames();
  EXPECT_EQ(probe->replies, (Replies{"TCP Receive 2 ''", "TCP Close 0"}));
}

TEST_F(TcpCloseTest, PendingOperationsAreAnsweredBeforeTheClose) {
  Receive(1, 10);
  peer.net.Close(peer.handle);
  Close();
  Frames();
  EXPECT_EQ(probe->replies, (Replies{"TCP Receive 2 ''", "TCP Close 0"}));
}

TEST_F(TcpCloseTest, AbortIsAnsweredAtOnceAndThePeerSeesAReset) {
  Receive(1, 10);
  Close(true);
  EXPECT_EQ(probe->replies, (Replies{"TCP Receive 2 ''", "TCP Close 0"}));
  Frames();
  EXPECT_EQ(peer.error, NetError::kReset);
}

TEST_F(TcpCloseTest, EveryOperationOnAClosedEndpointIsConnectionClosed) {
  Close(true);
  TakeReplies();
  Send("x");
  Receive(1, 1);
  Close();
  EXPECT_EQ(probe->replies, (Replies{"TCP Send 2", "TCP Receive 2 ''", "TCP Close 2"}));
}

TEST_F(TcpCloseTest, TransfersWhileClosingAreConnectionClosed) {
  Close();
  Send("x");
  Receive(1, 1);
  EXPECT_EQ(probe->replies, (Replies{"TCP Send 2", "TCP Receive 2 ''"}));
}

TEST_F(TcpCloseTest, SecondCloseIsBusy) {
  Close();
  Close();
  EXPECT_EQ(probe->replies, Replies{"TCP Close 5"});
}

TEST_F(TcpCloseTest, NewEndpointHasAnotherReference) {
  Close(true);
  Do([&] { EXPECT_NE(probe->NewEndpoint(EndpointType_TCP), endpoint); });
}

TEST_F(TcpCloseTest, CloseOfAListeningEndpointCancelsTheListen) {
  antModuleRef listening;
  Do([&] {
    listening = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(listening, IP_ADDR_ANY, kPort));
    probe->Send(TCPEndpointCloseMsg(listening));
  });
  EXPECT_EQ(probe->replies, (Replies{"TCP Listen 2", "TCP Close 0"}));
  TakeReplies();
  Peer late(hub, 0x0a000103);
  late.Connect(kPort);
  Frames(3);
  EXPECT_TRUE(probe->replies.empty());
}

TEST_F(TcpCloseTest, PeerThatNeverReadsIsGivenUpAfterAMinute) {
  StopPeerReading();
  for (int i = 0; i < 20; ++i) {
    Send(std::string(4096, 'x'));
    Frames();
  }
  TakeReplies();
  Close();
  system.RunFor(TcpEndpoint::kUnsentUs - 1'000'000);
  EXPECT_EQ(probe->replies, Replies{"TCP Send 2"});
  system.RunFor(2'000'000);
  EXPECT_EQ(probe->replies, (Replies{"TCP Send 2", "TCP Close 0"}));
}

TEST_F(TcpCloseTest, ObjectThatIsGoneLeavesNoEndpointAndNoBufferBehind) {
  Receive(1, 10);
  EXPECT_EQ(stack->endpoint_count(), 1u);
  {
    const CurrentScope scope(&system, &stack->host());
    stack->ForgetObject(probe->host().id);
  }
  EXPECT_EQ(stack->endpoint_count(), 0u);
  EXPECT_EQ(stack->buffers().count(), 0u);
  Frames();
  EXPECT_EQ(peer.error, NetError::kReset);
}

TEST_F(TcpCloseTest, ShutdownBreaksOpenConnections) {
  Receive(1, 10);
  system.Shutdown();
  system.RunFor(1'000'000);
  EXPECT_TRUE(system.powered_off());
  EXPECT_EQ(stack->endpoint_count(), 0u);
  peer.Poll();
  EXPECT_EQ(peer.error, NetError::kReset);
}

}  // namespace
}  // namespace openr_host
