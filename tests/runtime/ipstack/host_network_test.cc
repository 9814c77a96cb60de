// Tests of the stack with sockets of this computer, all at 127.0.0.1.
#include "runtime/ipstack/host_network.h"

#include <DNSEndpointMsg.h>
#include <dirent.h>
#include <gmock/gmock.h>

#include "tests/runtime/ipstack/echo_server.h"
#include "tests/runtime/ipstack/host_robot.h"

namespace openr_host {
namespace {

int OpenFiles() {
  DIR* const folder = opendir("/proc/self/fd");
  int count = 0;
  while (readdir(folder) != nullptr) ++count;
  closedir(folder);
  return count;
}

class HostNetworkTest : public HostRobotTest {};

TEST_F(HostNetworkTest, EchoesToTwoClientsOneAfterTheOther) {
  Start();
  system->AddObject<EchoServer>(0, "server", kPort, 1);
  Boot();
  for (const char* text : {"first", "second"}) {
    HostPeer client(NetProtocol::kTcp);
    ASSERT_TRUE(client.Connect(TcpPort()));
    client.Say(text);
    EXPECT_TRUE(Hears(&client, text)) << client.heard;
  }
}

TEST_F(HostNetworkTest, FourListenersOnOnePortServeFourClientsAtOnce) {
  Start();
  system->AddObject<EchoServer>(0, "server", kPort, 4);
  Boot();
  std::vector<HostPeer> clients;
  for (int i = 0; i < 4; ++i) {
    clients.emplace_back(NetProtocol::kTcp);
    ASSERT_TRUE(clients.back().Connect(TcpPort()));
  }
  for (HostPeer& client : clients) client.Say("hello");
  for (HostPeer& client : clients) EXPECT_TRUE(Hears(&client, "hello"));
}

TEST_F(HostNetworkTest, MegabyteComesBackUnchanged) {
  Start();
  system->AddObject<EchoServer>(0, "server", kPort, 1);
  Boot();
  HostPeer client(NetProtocol::kTcp);
  ASSERT_TRUE(client.Connect(TcpPort()));
  std::string all(1 << 20, '\0');
  for (size_t i = 0; i < all.size(); ++i) all[i] = static_cast<char>(i * 2654435761u >> 13);
  size_t said = 0;
  for (int i = 0; i < kTriesMax && client.heard.size() < all.size(); ++i) {
    const int64_t count = SendBytes(client.fd, all.data() + said, all.size() - said);
    if (count > 0) said += static_cast<size_t>(count);
    system->RunFor(kFrameUs);
    while (client.Hear()) {
    }
  }
  EXPECT_TRUE(client.heard == all) << said << " said, " << client.heard.size() << " heard";
}

TEST_F(HostNetworkTest, PeerSeesTheEndAfterTheData) {
  Start();
  Boot();
  antModuleRef endpoint;
  Do([&] {
    endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort));
  });
  HostPeer client(NetProtocol::kTcp);
  ASSERT_TRUE(client.Connect(TcpPort()));
  ASSERT_TRUE(Until([&] { return !probe->replies.empty(); }));
  Do([&] {
    byte* const buffer = probe->NewBuffer(10);
    std::memcpy(buffer, "goodbye", 7);
    probe->Send(TCPEndpointSendMsg(endpoint, buffer, 7));
    probe->Send(TCPEndpointCloseMsg(endpoint));
  });
  EXPECT_TRUE(Hears(&client, "goodbye"));
  EXPECT_TRUE(Until([&] {
    client.Hear();
    return client.ended;
  }));
  EndStream(client.fd);
  EXPECT_TRUE(Until([&] { return probe->replies.size() == 3; }));
  EXPECT_EQ(probe->replies, (Replies{"TCP Listen 0", "TCP Send 0", "TCP Close 0"}));
}

TEST_F(HostNetworkTest, AbortIsAResetOnTheWire) {
  Start();
  Boot();
  antModuleRef endpoint;
  Do([&] {
    endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort));
  });
  HostPeer client(NetProtocol::kTcp);
  ASSERT_TRUE(client.Connect(TcpPort()));
  ASSERT_TRUE(Until([&] { return !probe->replies.empty(); }));
  Do([&] { probe->Send(TCPEndpointCloseMsg(endpoint, false, 0, true)); });
  EXPECT_TRUE(Until([&] {
    client.Hear();
    return client.reset;
  }));
}

TEST_F(HostNetworkTest, ClientThatDisappearsWithAResetEndsTheReceive) {
  Start();
  Boot();
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    byte* const buffer = probe->NewBuffer(10);
    probe->on_reply = [this, endpoint, buffer](antEnvMsg* m) mutable {
      if (m->GetOperation() == TCPEndpoint_Operation_Listen) {
        probe->Send(TCPEndpointReceiveMsg(endpoint, buffer, 1, 10));
      }
    };
    probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort));
  });
  {
    HostPeer client(NetProtocol::kTcp);
    ASSERT_TRUE(client.Connect(TcpPort()));
    ASSERT_TRUE(Until([&] { return !probe->replies.empty(); }));
    ResetOnClose(client.fd);
  }
  ASSERT_TRUE(Until([&] { return probe->replies.size() == 2; }));
  EXPECT_EQ(probe->replies[1], "TCP Receive 3 ''");
}

TEST_F(HostNetworkTest, ConnectReachesAServerOfTheHost) {
  Fd server = OpenSocket(NetProtocol::kTcp);
  ASSERT_EQ(ListenOn(server, {kLocal, 0}, 1), 0);
  HostNetworkOptions options;
  options.addresses = {{kClientIp, kLocal}};  // the address that EchoClient has compiled in
  Start(options);
  Boot();
  const uint16_t port = PortOf(server);
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointConnectMsg(endpoint, IP_ADDR_ANY, IP_PORT_ANY, kClientIp, port));
  });
  EXPECT_TRUE(Until([&] { return !probe->replies.empty(); }));
  EXPECT_EQ(probe->replies, Replies{"TCP Connect 0"});
  NetAddress from;
  EXPECT_TRUE(AcceptFrom(server, &from).valid());
}

TEST_F(HostNetworkTest, ConnectToAClosedPortIsPortUnreachable) {
  uint16_t closed = 0;
  {
    Fd server = OpenSocket(NetProtocol::kTcp);
    ASSERT_EQ(BindSocket(server, {kLocal, 0}), 0);
    closed = PortOf(server);
  }
  HostNetworkOptions options;
  options.addresses = {{kClientIp, kLocal}};
  Start(options);
  Boot();
  Do([&] {
    antModuleRef a = probe->NewEndpoint(EndpointType_TCP);
    antModuleRef b = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointConnectMsg(a, IP_ADDR_ANY, IP_PORT_ANY, kClientIp, closed));
    // The address is that of the robot itself, but no object listens on the port.
    probe->Send(TCPEndpointConnectMsg(b, IP_ADDR_ANY, IP_PORT_ANY, kRobotIp, closed));
  });
  EXPECT_TRUE(Until([&] { return probe->replies.size() == 2; }));
  EXPECT_EQ(probe->replies, (Replies{"TCP Connect 8", "TCP Connect 8"}));
}

TEST_F(HostNetworkTest, ObjectsOfOneRobotTalkThroughSockets) {
  Start();
  system->AddObject<EchoServer>(0, "server", kPort, 1);
  auto* const client = system->AddObject<EchoClient>(0, "client", kRobotIp, kPort, 5);
  Boot();
  EXPECT_TRUE(Until([&] { return client->closed; }));
  EXPECT_EQ(client->bounced, 5);
}

TEST_F(HostNetworkTest, PortThatWasAskedForAndIsTakenIsNotReplaced) {
  Fd taken = OpenSocket(NetProtocol::kTcp);
  ASSERT_EQ(ListenOn(taken, {kLocal, 0}, 1), 0);
  HostNetworkOptions options;
  options.tcp_ports[kPort] = PortOf(taken);
  Start(options);
  system->AddObject<EchoServer>(0, "server", kPort, 1);
  Boot();
  EXPECT_EQ(TcpPort(), 0);
  ASSERT_TRUE(Until([&] { return !system->findings().all().empty(); }));
  EXPECT_THAT(system->findings().all()[0].text,
              testing::StartsWith(fmt::format("TCP port {} of the robot is nowhere", kPort)));
}

TEST_F(HostNetworkTest, PortThatIsTakenIsMappedToAFreeOneAndSaidSo) {
  Fd taken = OpenSocket(NetProtocol::kTcp);
  // If this fails, the port is in use already, which is what the test needs.
  ListenOn(taken, {kLocal, kPort}, 1);
  Start(HostNetworkOptions());
  system->AddObject<EchoServer>(0, "server", kPort, 1);
  Boot();
  EXPECT_NE(TcpPort(), 0);
  EXPECT_NE(TcpPort(), kPort);
  HostPeer client(NetProtocol::kTcp);
  ASSERT_TRUE(client.Connect(TcpPort()));
  client.Say("hello");
  EXPECT_TRUE(Hears(&client, "hello"));
  ASSERT_EQ(system->findings().all().size(), 1u);
  EXPECT_THAT(system->findings().all()[0].text,
              testing::StartsWith(fmt::format(
                  "TCP port {} of the robot is port {} of this computer", kPort, TcpPort())));
}

TEST_F(HostNetworkTest, PortStaysTheSameFromListenToListen) {
  Start();
  system->AddObject<EchoServer>(0, "server", kPort, 1);
  Boot();
  const uint16_t port = TcpPort();
  for (int i = 0; i < 3; ++i) {
    HostPeer client(NetProtocol::kTcp);
    ASSERT_TRUE(client.Connect(port));
    client.Say("x");
    EXPECT_TRUE(Hears(&client, "x"));
    EXPECT_EQ(TcpPort(), port);
  }
}

TEST_F(HostNetworkTest, UdpEchoesToTheOrigin) {
  Start();
  Boot();
  antModuleRef endpoint;
  Do([&] {
    endpoint = probe->NewEndpoint(EndpointType_UDP);
    byte* const buffer = probe->NewBuffer(100);
    probe->Send(UDPEndpointBindMsg(endpoint, IP_ADDR_ANY, kPort));
    probe->Send(UDPEndpointReceiveMsg(endpoint, buffer, 100));
    probe->on_reply = [this, endpoint](antEnvMsg* m) mutable {
      if (m->GetOperation() != UDPEndpoint_Operation_Receive) return;
      const auto& got = *static_cast<UDPEndpointReceiveMsg*>(m);
      probe->Send(UDPEndpointSendMsg(endpoint, got.address, got.port, got.buffer, got.size));
    };
  });
  HostPeer client(NetProtocol::kUdp);
  ASSERT_GE(
      SendDatagram(client.fd, {kLocal, stack->HostPort(NetProtocol::kUdp, kPort)}, "hello", 5), 0);
  EXPECT_TRUE(Hears(&client, "hello"));
}

TEST_F(HostNetworkTest, UdpBetweenObjectsShowsTheRobotsOwnAddress) {
  Start();
  Boot();
  NetAddress origin;
  probe->on_reply = [&](antEnvMsg* m) {
    if (m->GetOperation() != UDPEndpoint_Operation_Receive) return;
    const auto& got = *static_cast<UDPEndpointReceiveMsg*>(m);
    origin = {got.address.Address(), got.port};
  };
  Do([&] {
    byte* const buffer = probe->NewBuffer(100);
    antModuleRef a = probe->NewEndpoint(EndpointType_UDP);
    antModuleRef b = probe->NewEndpoint(EndpointType_UDP);
    probe->Send(UDPEndpointBindMsg(a, IP_ADDR_ANY, kPort));
    probe->Send(UDPEndpointBindMsg(b, IP_ADDR_ANY, IP_PORT_ANY));
    probe->Send(UDPEndpointReceiveMsg(a, buffer, 100));
    probe->Send(UDPEndpointSendMsg(b, kRobotIp, kPort, buffer + 50, 3));
  });
  EXPECT_TRUE(Until([&] { return origin.port != 0; }));
  EXPECT_EQ(origin, (NetAddress{kRobotIp, 1024}));
}

TEST_F(HostNetworkTest, NamesOfTheTableAreAnsweredWithoutAskingAnybody) {
  HostNetworkOptions options;
  options.names["clock.example.net"] = {"clock.example.net", {}, {7}};
  Start(options);
  Boot();
  IPAddress found;
  probe->on_reply = [&](antEnvMsg* m) {
    found = static_cast<DNSEndpointGetHostByNameMsg*>(m)->host_address;
  };
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_DNS);
    probe->Send(DNSEndpointGetHostByNameMsg(endpoint, "clock.example.net."));
  });
  EXPECT_TRUE(Until([&] { return !probe->replies.empty(); }));
  EXPECT_EQ(found, IPAddress(7));
}

TEST_F(HostNetworkTest, LocalhostIsKnownToTheHostsResolver) {
  Start();
  Boot();
  IPAddress found;
  probe->on_reply = [&](antEnvMsg* m) {
    found = static_cast<DNSEndpointGetHostByNameMsg*>(m)->host_address;
  };
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_DNS);
    probe->Send(DNSEndpointGetHostByNameMsg(endpoint, "localhost."));
  });
  EXPECT_TRUE(Until([&] { return !probe->replies.empty(); }));
  EXPECT_EQ(found, IPAddress(kLocal));
}

TEST_F(HostNetworkTest, NoFileIsLeftOpenWhenTheSystemGoes) {
  const int before = OpenFiles();
  Start();
  system->AddObject<EchoServer>(0, "server", kPort, 4);
  Boot();
  Do([&] {
    antModuleRef udp = probe->NewEndpoint(EndpointType_UDP);
    probe->Send(UDPEndpointBindMsg(udp, IP_ADDR_ANY, kPort));
  });
  {
    HostPeer client(NetProtocol::kTcp);
    ASSERT_TRUE(client.Connect(TcpPort()));
    client.Say("x");
    EXPECT_TRUE(Hears(&client, "x"));
  }
  EXPECT_GT(OpenFiles(), before);
  system.reset();
  EXPECT_EQ(OpenFiles(), before);
}

TEST_F(HostNetworkTest, ShutdownClosesThePort) {
  Start();
  system->AddObject<EchoServer>(0, "server", kPort, 1);
  Boot();
  const uint16_t port = TcpPort();
  system->Shutdown();
  EXPECT_TRUE(Until([&] { return system->powered_off(); }));
  Fd again = OpenSocket(NetProtocol::kTcp);
  EXPECT_EQ(ListenOn(again, {kLocal, port}, 1), 0);
}

}  // namespace
}  // namespace openr_host
