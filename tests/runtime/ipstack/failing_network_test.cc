// Every command of the network fails in turn; the program always gets its answer.
#include "runtime/ipstack/failing_network.h"

#include <DNSEndpointMsg.h>

#include "tests/runtime/ipstack/echo_server.h"

namespace openr_host {
namespace {

// A robot on whose network command number `nth` fails, and a probe that records its answers.
class FailingNetworkTest : public testing::Test {
 protected:
  void Start(int nth, NetError error) {
    system.AddRobot("ERS-210", nullptr);
    stack = AddIpStack(
        &system, 0,
        std::make_unique<FailingNetwork>(std::make_unique<LoopbackNetwork>(hub), nth, error));
    probe = system.AddObject<NetProbe>(0, "probe");
    system.Boot();
    system.RunFor(1000);
  }
  void Do(std::function<void()> body) {
    probe->Do(std::move(body));
    system.RunFor(1);
  }
  void Frames(int count) {
    for (int i = 0; i < count; ++i) {
      system.RunFor(kFrameUs);
      peer.Poll();
    }
  }

  std::shared_ptr<LoopbackHub> hub = std::make_shared<LoopbackHub>();
  Peer peer{hub};
  System system;
  IpStack* stack = nullptr;
  NetProbe* probe = nullptr;
};

TEST_F(FailingNetworkTest, ListenThatFailsIsAnsweredAndMayBeTriedAgain) {
  Start(1, NetError::kAddressInUse);
  antModuleRef first;
  Do([&] {
    first = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(first, IP_ADDR_ANY, kPort));
  });
  Frames(1);
  EXPECT_EQ(probe->replies, Replies{"TCP Listen 6"});
  Do([&] {
    probe->Send(TCPEndpointCloseMsg(first));
    antModuleRef second = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(second, IP_ADDR_ANY, kPort));
  });
  peer.Connect(kPort);
  Frames(2);
  EXPECT_EQ(probe->replies, (Replies{"TCP Listen 6", "TCP Close 0", "TCP Listen 0"}));
}

TEST_F(FailingNetworkTest, ConnectThatFailsCarriesTheReason) {
  Start(1, NetError::kNetworkUnreachable);
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointConnectMsg(endpoint, IP_ADDR_ANY, IP_PORT_ANY, kClientIp, 7));
  });
  Frames(1);
  EXPECT_EQ(probe->replies, Replies{"TCP Connect 11"});
}

TEST_F(FailingNetworkTest, BrokenConnectionAnswersReceiveSendAndClose) {
  Start(3, NetError::kTimeout);  // the third command, after Listen and Accept, is Receive
  antModuleRef endpoint;
  byte* buffer = nullptr;
  Do([&] {
    endpoint = probe->NewEndpoint(EndpointType_TCP);
    buffer = probe->NewBuffer(100);
    probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort));
  });
  peer.Connect(kPort);
  Frames(2);
  Do([&] { probe->Send(TCPEndpointReceiveMsg(endpoint, buffer, 1, 10)); });
  Frames(1);
  Do([&] {
    probe->Send(TCPEndpointSendMsg(endpoint, buffer, 1));
    probe->Send(TCPEndpointCloseMsg(endpoint));
  });
  EXPECT_EQ(probe->replies,
            (Replies{"TCP Listen 0", "TCP Receive 4 ''", "TCP Send 4", "TCP Close 0"}));
  EXPECT_EQ(stack->endpoint_count(), 0u);
}

TEST_F(FailingNetworkTest, UdpSocketThatCannotBeMadeFailsTheTransfers) {
  Start(1, NetError::kFailed);
  antModuleRef endpoint;
  Do([&] {
    endpoint = probe->NewEndpoint(EndpointType_UDP);
    byte* const buffer = probe->NewBuffer(100);
    probe->Send(UDPEndpointBindMsg(endpoint, IP_ADDR_ANY, kPort));
    probe->Send(UDPEndpointReceiveMsg(endpoint, buffer, 100));
  });
  Frames(1);
  EXPECT_EQ(probe->replies, (Replies{"UDP Bind 0", "UDP Receive 1"}));
}

TEST_F(FailingNetworkTest, ResolverThatTimesOutIsTryAgain) {
  Start(1, NetError::kTimeout);
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_DNS);
    probe->Send(DNSEndpointGetHostByNameMsg(endpoint, "x."));
  });
  Frames(1);
  EXPECT_EQ(probe->replies, Replies{"DNS GetHostByName 3"});
}

// Whichever command fails, the server ends up listening again.
TEST(FailingNetworkEchoTest, ServerSurvivesTheFailureOfAnyCommand) {
  for (int nth = 1; nth <= 12; ++nth) {
    SCOPED_TRACE(nth);
    auto hub = std::make_shared<LoopbackHub>();
    System system;
    system.AddRobot("ERS-210", nullptr);
    AddIpStack(&system, 0,
               std::make_unique<FailingNetwork>(std::make_unique<LoopbackNetwork>(hub), nth,
                                                NetError::kReset));
    system.AddObject<EchoServer>(0, "server", kPort, 1);
    Peer peer(hub);
    system.Boot();
    std::string last;
    for (int client = 0; client < 6; ++client) {
      system.RunFor(kFrameUs * 2);
      peer.heard.clear();
      peer.Connect(kPort);
      peer.Say("hello");
      for (int i = 0; i < 4; ++i) {
        system.RunFor(kFrameUs);
        peer.Poll();
      }
      last = peer.heard;
      peer.net.Drop(peer.handle, true);
    }
    EXPECT_EQ(last, "hello");
  }
}

}  // namespace
}  // namespace openr_host
