// Tests of single TCP operations; numbers in answers are those of TCPEndpointError.
#include "tests/runtime/ipstack/net_probe.h"

namespace openr_host {
namespace {

using TcpTest = NetTest;

TEST_F(TcpTest, ListenAnswersWithAllFourAddressesWhenAClientHasConnected) {
  TCPEndpointListenMsg answer;
  probe->on_reply = [&](antEnvMsg* m) { answer = *static_cast<TCPEndpointListenMsg*>(m); };
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort));
  });
  Frames(3);
  EXPECT_TRUE(probe->replies.empty());
  peer.Connect(kPort, 40007);
  Frames();
  EXPECT_EQ(answer.error, TCP_SUCCESS);
  EXPECT_EQ(answer.lAddress, IPAddress(kRobotIp));
  EXPECT_EQ(answer.lPort, kPort);
  EXPECT_EQ(answer.fAddress, IPAddress(kClientIp));
  EXPECT_EQ(answer.fPort, 40007);
}

TEST_F(TcpTest, WhatComesFromOutsideIsAnsweredAtAFrameBoundary) {
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort));
  });
  system.RunFor(3333);
  peer.Connect(kPort);
  system.RunFor(20'000);
  ASSERT_EQ(probe->reply_times_us.size(), 1u);
  EXPECT_EQ(probe->reply_times_us[0] % kFrameUs, 0);
}

TEST_F(TcpTest, ConnectAnswersWithTheLocalEnd) {
  peer.net.Listen(Peer::kListener, 7);
  peer.net.Accept(Peer::kListener, peer.handle);
  TCPEndpointConnectMsg answer;
  probe->on_reply = [&](antEnvMsg* m) { answer = *static_cast<TCPEndpointConnectMsg*>(m); };
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointConnectMsg(endpoint, IP_ADDR_ANY, IP_PORT_ANY, kClientIp, 7));
  });
  Frames();
  EXPECT_EQ(answer.error, TCP_SUCCESS);
  EXPECT_EQ(answer.lAddress, IPAddress(kRobotIp));
  EXPECT_GE(answer.lPort, 1024);
  EXPECT_EQ(answer.fAddress, IPAddress(kClientIp));
  EXPECT_EQ(answer.fPort, 7);
  EXPECT_TRUE(peer.connected);
}

TEST_F(TcpTest, ConnectKeepsTheLocalPortItIsGiven) {
  peer.net.Listen(Peer::kListener, 7);
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->on_reply = [](antEnvMsg* m) {
      EXPECT_EQ(static_cast<TCPEndpointConnectMsg*>(m)->lPort, 20);
    };
    probe->Send(TCPEndpointConnectMsg(endpoint, IP_ADDR_ANY, 20, kClientIp, 7));
  });
  Frames();
  EXPECT_EQ(probe->replies, Replies{"TCP Connect 0"});
}

TEST_F(TcpTest, ConnectToAPortWhereNobodyListensIsPortUnreachable) {
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointConnectMsg(endpoint, IP_ADDR_ANY, IP_PORT_ANY, kClientIp, 7));
  });
  Frames();
  EXPECT_EQ(probe->replies, Replies{"TCP Connect 8"});
}

TEST_F(TcpTest, ConnectToAnAddressThatNobodyHasIsHostUnreachable) {
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointConnectMsg(endpoint, IP_ADDR_ANY, IP_PORT_ANY, 0x0a000163, 7));
  });
  Frames();
  EXPECT_EQ(probe->replies, Replies{"TCP Connect 10"});
}

TEST_F(TcpTest, ConnectWithoutADestinationAndListenOnAStrangersAddressAreAddressErrors) {
  Do([&] {
    antModuleRef a = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointConnectMsg(a, IP_ADDR_ANY, IP_PORT_ANY, 0, 7));
    probe->Send(TCPEndpointListenMsg(a, kClientIp, kPort));
  });
  EXPECT_EQ(probe->replies, (Replies{"TCP Connect 7", "TCP Listen 7"}));
}

TEST_F(TcpTest, SecondListenOnAListeningEndpointIsBusy) {
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort));
    probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort));
  });
  EXPECT_EQ(probe->replies, Replies{"TCP Listen 5"});
}

TEST_F(TcpTest, TransferBeforeAConnectionIsInvalid) {
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    byte* const buffer = probe->NewBuffer(100);
    probe->Send(TCPEndpointSendMsg(endpoint, buffer, 1));
    probe->Send(TCPEndpointReceiveMsg(endpoint, buffer, 1, 1));
  });
  EXPECT_EQ(probe->replies, (Replies{"TCP Send 17", "TCP Receive 17 ''"}));
}

TEST_F(TcpTest, UndocumentedOperationsAreUnknown) {
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointBacklogQueueMsg(endpoint, 3));
    TCPEndpointAcceptMsg accept(endpoint);
    accept.dstOperation = 77;
    probe->Send(accept);
  });
  EXPECT_EQ(probe->replies, (Replies{"TCP BacklogQueue 18", "unknown TCP operation 18"}));
}

TEST_F(TcpTest, BindGivesListenItsPort) {
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointBindMsg(endpoint, IP_ADDR_ANY, kPort));
    probe->Send(TCPEndpointListenMsg(endpoint));
  });
  peer.Connect(kPort);
  Frames();
  EXPECT_EQ(probe->replies, (Replies{"TCP Bind 0", "TCP Listen 0"}));
}

TEST_F(TcpTest, ListenForOnePeerTurnsOthersAway) {
  Peer other(hub, 0x0a000103);
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort, kClientIp, IP_PORT_ANY));
  });
  other.Connect(kPort);
  Frames();
  other.Poll();
  EXPECT_EQ(other.error, NetError::kReset);
  EXPECT_TRUE(probe->replies.empty());
  peer.Connect(kPort);
  Frames();
  EXPECT_EQ(probe->replies, Replies{"TCP Listen 0"});
}

using TcpConnectedTest = ConnectedTest;

TEST_F(TcpConnectedTest, ReceiveWithSizeMin1DeliversAnyPiece) {
  Receive(1, 100);
  Frames(2);
  EXPECT_TRUE(probe->replies.empty());
  peer.Say("abc");
  Frames();
  EXPECT_EQ(probe->replies, Replies{"TCP Receive 0 'abc'"});
}

TEST_F(TcpConnectedTest, ReceiveWaitsForSizeMinOverSeveralPieces) {
  Receive(6, 100);
  for (const char* piece : {"ab", "cd", "efg"}) {
    EXPECT_TRUE(probe->replies.empty());
    peer.Say(piece);
    Frames(2);
  }
  EXPECT_EQ(probe->replies, Replies{"TCP Receive 0 'abcdefg'"});
}

TEST_F(TcpConnectedTest, ReceiveDeliversAtMostSizeMaxAndKeepsTheRest) {
  peer.Say("abcdefgh");
  Receive(1, 3);
  Frames();
  Receive(5, 100);
  Frames();
  EXPECT_EQ(probe->replies, (Replies{"TCP Receive 0 'abc'", "TCP Receive 0 'defgh'"}));
}

TEST_F(TcpConnectedTest, WhatCameInOneFrameIsReadAtOneInstant) {
  peer.Say("4:body");
  Receive(2, 2);
  probe->on_reply = [&](antEnvMsg*) {
    probe->on_reply = {};
    probe->Send(TCPEndpointReceiveMsg(endpoint, buffer, 4, 4));
  };
  Frames();
  EXPECT_EQ(probe->replies, (Replies{"TCP Receive 0 '4:'", "TCP Receive 0 'body'"}));
}

TEST_F(TcpConnectedTest, ReceiveDeliversNothingBehindSizeMax) {
  peer.Say("abcdefgh");
  Do([&] { std::memset(buffer, '.', 8); });
  Receive(1, 3);
  Frames();
  EXPECT_EQ(std::string(reinterpret_cast<char*>(buffer), 5), "abc..");
}

TEST_F(TcpConnectedTest, DataComeBeforeConnectionClosedNeverWithIt) {
  peer.Say("last");
  peer.net.Close(peer.handle);
  Receive(1, 100);
  Frames();
  Receive(1, 100);
  Frames();
  Receive(1, 100);
  EXPECT_EQ(probe->replies,
            (Replies{"TCP Receive 0 'last'", "TCP Receive 2 ''", "TCP Receive 2 ''"}));
}

TEST_F(TcpConnectedTest, EndOfStreamGivesTheRestThatIsLessThanSizeMin) {
  peer.Say("rest");
  peer.net.Close(peer.handle);
  Receive(50, 100);
  Frames(2);
  Receive(50, 100);
  Frames();
  EXPECT_EQ(probe->replies, (Replies{"TCP Receive 0 'rest'", "TCP Receive 2 ''"}));
}

TEST_F(TcpConnectedTest, ResetByThePeerAnswersThePendingReceive) {
  Receive(1, 100);
  peer.net.Drop(peer.handle, true);
  Frames();
  Receive(1, 100);
  EXPECT_EQ(probe->replies, (Replies{"TCP Receive 3 ''", "TCP Receive 3 ''"}));
}

TEST_F(TcpConnectedTest, SendIsAnsweredAtOnceWhenItFitsIntoThePool) {
  Send("hello");
  EXPECT_EQ(probe->replies, Replies{"TCP Send 0"});
  Frames();
  EXPECT_EQ(peer.heard, "hello");
}

TEST_F(TcpConnectedTest, BufferOfAnAnsweredSendMayBeReused) {
  Do([&] {
    std::memcpy(buffer, "good", 4);
    TCPEndpointSendMsg send(endpoint, buffer, 4);
    send.Call(probe->Stack(), sizeof send);
    std::memcpy(buffer, "evil", 4);
  });
  Frames();
  EXPECT_EQ(peer.heard, "good");
}

TEST_F(TcpConnectedTest, SendLargerThanThePoolFailsAndIsReported) {
  Do([&] { probe->Send(TCPEndpointSendMsg(endpoint, buffer, 4097)); });
  EXPECT_EQ(probe->replies, Replies{"TCP Send 1"});
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_EQ(system.findings().all()[0].object, "probe");
}

TEST_F(TcpConnectedTest, SendWaitsWhileThePeerDoesNotReadAndThePoolIsFull) {
  StopPeerReading();
  const std::string block(4096, 'x');
  int sent = 0;
  while (sent < 100) {
    Send(block);
    Frames();
    if (TakeReplies().empty()) break;
    ++sent;
  }
  // Sends are answered until window and pool are full; the next one waits.
  EXPECT_EQ(sent, static_cast<int>(LoopbackNetwork::kWindowBytes / block.size()) + 1);
  peer.reading = true;
  Frames(3);
  EXPECT_EQ(probe->replies, Replies{"TCP Send 0"});
  EXPECT_EQ(peer.heard.size(), 1 + block.size() * static_cast<size_t>(sent + 1));
}

TEST_F(TcpConnectedTest, SecondSendAndSecondReceiveAreBusy) {
  StopPeerReading();
  for (int i = 0; i < 20; ++i) {
    Send(std::string(4096, 'x'));
    Frames();
  }
  const Replies replies = TakeReplies();
  EXPECT_EQ(replies.front(), "TCP Send 0");
  EXPECT_EQ(replies.back(), "TCP Send 5");
  Receive(1, 10);
  Receive(1, 10);
  EXPECT_EQ(probe->replies, Replies{"TCP Receive 5 ''"});
}

TEST_F(TcpConnectedTest, OneSendAndOneReceiveMayBePendingTogether) {
  Receive(1, 10);
  Send("ping");
  peer.Say("pong");
  Frames();
  EXPECT_EQ(probe->replies, (Replies{"TCP Send 0", "TCP Receive 0 'pong'"}));
}

TEST_F(TcpConnectedTest, RangesOutsideOfSharedBuffersAreInvalid) {
  byte stack_memory[16] = {};
  Do([&] {
    probe->Send(TCPEndpointSendMsg(endpoint, stack_memory, 16));
    probe->Send(TCPEndpointSendMsg(endpoint, nullptr, 16));
    probe->Send(TCPEndpointSendMsg(endpoint, buffer + 8000, 193));  // a byte too long
    probe->Send(TCPEndpointSendMsg(endpoint, buffer - 1, 4));
    probe->Send(TCPEndpointReceiveMsg(endpoint, buffer, 1, 8193));
    probe->Send(TCPEndpointSendMsg(endpoint, buffer + 8000, 192));
  });
  EXPECT_EQ(probe->replies, (Replies{"TCP Send 16", "TCP Send 16", "TCP Send 16", "TCP Send 16",
                                     "TCP Receive 16 ''", "TCP Send 0"}));
}

TEST_F(TcpConnectedTest, ZeroAndNegativeSizesAreInvalid) {
  Do([&] {
    probe->Send(TCPEndpointSendMsg(endpoint, buffer, 0));
    probe->Send(TCPEndpointSendMsg(endpoint, buffer, -1));
    probe->Send(TCPEndpointReceiveMsg(endpoint, buffer, 0, 10));
    probe->Send(TCPEndpointReceiveMsg(endpoint, buffer, 1, 0));
    probe->Send(TCPEndpointReceiveMsg(endpoint, buffer, -5, -1));
    probe->Send(TCPEndpointReceiveMsg(endpoint, buffer, 11, 10));
  });
  EXPECT_EQ(probe->replies,
            (Replies{"TCP Send 16", "TCP Send 16", "TCP Receive 16 ''", "TCP Receive 16 ''",
                     "TCP Receive 16 ''", "TCP Receive 16 ''"}));
}

TEST_F(TcpConnectedTest, BufferThatIsUnmappedOrDestroyedIsInvalid) {
  Do([&] {
    probe->buffers[0].UnMap();
    probe->Send(TCPEndpointSendMsg(endpoint, buffer, 1));
    antEnvDestroySharedBufferMsg destroy(probe->buffers[0]);
    destroy.Call(probe->Stack(), sizeof destroy);
    EXPECT_EQ(destroy.error, ANT_SUCCESS);
    probe->Send(TCPEndpointSendMsg(endpoint, buffer, 1));
  });
  EXPECT_EQ(probe->replies, (Replies{"TCP Send 16", "TCP Send 16"}));
}

TEST_F(TcpConnectedTest, NothingIsWrittenIntoABufferDestroyedWhileAReceiveWaits) {
  Receive(1, 100);
  Do([&] {
    probe->buffers[0].UnMap();
    antEnvDestroySharedBufferMsg destroy(probe->buffers[0]);
    destroy.Call(probe->Stack(), sizeof destroy);
  });
  peer.Say("too late");
  Frames();
  EXPECT_EQ(probe->replies, Replies{"TCP Receive 16 ''"});
}

TEST_F(TcpConnectedTest, AddressTellsBothEnds) {
  probe->on_reply = [](antEnvMsg* m) {
    const auto& address = *static_cast<TCPEndpointAddressMsg*>(m);
    EXPECT_EQ(address.lPort, kPort);
    EXPECT_EQ(address.fAddress, IPAddress(kClientIp));
  };
  Do([&] { probe->Send(TCPEndpointAddressMsg(endpoint)); });
  EXPECT_EQ(probe->replies, Replies{"TCP Address 0"});
}

}  // namespace
}  // namespace openr_host
