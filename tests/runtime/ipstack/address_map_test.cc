// Tests of old addresses that programs contain, with sockets of this computer.
#include "runtime/ipstack/address_map.h"

#include <DNSEndpointMsg.h>
#include <gmock/gmock.h>

#include "tests/runtime/ipstack/echo_server.h"
#include "tests/runtime/ipstack/host_robot.h"

namespace openr_host {
namespace {

constexpr uint32_t kOtherIp = 0x0a000165;  // 10.0.1.101, another robot
constexpr uint32_t kSecondLocal = 0x7f000002;

TEST(AddressMapTest, TheAddressSpokenToLastIsTheOneThatAnswers) {
  AddressMap map({{kClientIp, kLocal}, {kOtherIp, kLocal}});
  EXPECT_EQ(map.FromHost(NetAddress{kLocal, 80}), (NetAddress{kClientIp, 80}));
  EXPECT_EQ(map.ToHost(NetAddress{kOtherIp, 80}), (NetAddress{kLocal, 80}));
  EXPECT_EQ(map.FromHost(NetAddress{kLocal, 80}), (NetAddress{kOtherIp, 80}));
  EXPECT_EQ(map.FromHost(NetAddress{kLocal, 81}), (NetAddress{kClientIp, 81}));
  EXPECT_EQ(map.ToHost(NetAddress{kRobotIp, 80}), (NetAddress{kRobotIp, 80}));
  EXPECT_EQ(map.FromHost(NetAddress{kRobotIp, 80}), (NetAddress{kRobotIp, 80}));
}

class AddressesTest : public HostRobotTest {
 protected:
  void StartWith(std::vector<AddressPair> addresses) {
    HostNetworkOptions options = AnyPort();
    options.addresses = std::move(addresses);
    Start(std::move(options));
    Boot();
  }
};

TEST_F(AddressesTest, AConnectionShowsTheAddressThatTheProgramKnows) {
  Fd server = OpenSocket(NetProtocol::kTcp);
  ASSERT_EQ(ListenOn(server, {kLocal, 0}, 1), 0);
  StartWith({{kOtherIp, kLocal}});
  NetAddress seen;
  probe->on_reply = [&](antEnvMsg* m) {
    const auto& connected = *static_cast<TCPEndpointConnectMsg*>(m);
    seen = {connected.fAddress.Address(), connected.fPort};
  };
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(
        TCPEndpointConnectMsg(endpoint, IP_ADDR_ANY, IP_PORT_ANY, kOtherIp, PortOf(server)));
  });
  EXPECT_TRUE(Until([&] { return seen.port != 0; }));
  EXPECT_EQ(seen, (NetAddress{kOtherIp, PortOf(server)}));
  NetAddress from;
  EXPECT_TRUE(AcceptFrom(server, &from).valid());
}

// A program for a PC knows the robot as 10.0.1.100, but here that is also its own address.
TEST_F(AddressesTest, TheRobotsOwnAddressMayBeAnotherRobot) {
  Fd server = OpenSocket(NetProtocol::kTcp);
  ASSERT_EQ(ListenOn(server, {kLocal, 0}, 1), 0);
  StartWith({{kRobotIp, kLocal}});
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(
        TCPEndpointConnectMsg(endpoint, IP_ADDR_ANY, IP_PORT_ANY, kRobotIp, PortOf(server)));
  });
  EXPECT_TRUE(Until([&] { return !probe->replies.empty(); }));
  EXPECT_EQ(probe->replies, std::vector<std::string>{"TCP Connect 0"});
}

TEST_F(AddressesTest, AClientAppearsUnderTheAddressOfItsTime) {
  StartWith({{kClientIp, kLocal}});
  NetAddress seen;
  probe->on_reply = [&](antEnvMsg* m) {
    const auto& accepted = *static_cast<TCPEndpointListenMsg*>(m);
    seen = {accepted.fAddress.Address(), accepted.fPort};
  };
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort));
  });
  HostPeer client(NetProtocol::kTcp);
  ASSERT_TRUE(client.Connect(TcpPort()));
  EXPECT_TRUE(Until([&] { return seen.port != 0; }));
  EXPECT_EQ(seen, (NetAddress{kClientIp, PortOf(client.fd)}));
}

TEST_F(AddressesTest, AServerBoundToAnAddressIsFoundWhereThatIs) {
  StartWith({{kOtherIp, kSecondLocal}});
  NetAddress local;
  probe->on_reply = [&](antEnvMsg* m) {
    const auto& accepted = *static_cast<TCPEndpointListenMsg*>(m);
    local = {accepted.lAddress.Address(), accepted.lPort};
  };
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(endpoint, kOtherIp, kPort));
  });
  Fd client = OpenSocket(NetProtocol::kTcp);
  const int error = ConnectTo(client, {kSecondLocal, TcpPort()});
  EXPECT_TRUE(error == 0 || error == EINPROGRESS) << error;
  EXPECT_TRUE(Until([&] { return local.port != 0; }));
  EXPECT_EQ(local, (NetAddress{kOtherIp, kPort}));
}

TEST(HostNetworkAttachTest, AfterABootWithAnotherAddressThePairOfTheOldOneIsNotUsed) {
  HostNetworkOptions options;
  options.tcp_ports[kPort] = 0;
  options.addresses = {{kRobotIp, kSecondLocal}};
  HostNetwork network(options);
  network.Attach(kRobotIp);
  network.Attach(kOtherIp);
  network.Listen(1, kPort);
  const Fd client = OpenSocket(NetProtocol::kTcp);
  int error = ConnectTo(client, {kLocal, network.HostPort(NetProtocol::kTcp, kPort)});
  for (int i = 0; i < kTriesMax && error == EINPROGRESS; ++i) error = ConnectResult(client);
  EXPECT_EQ(error, 0);
}

TEST_F(AddressesTest, AnAddressThatNobodySpokeOfCannotBeBoundTo) {
  StartWith({});
  Do([&] {
    antModuleRef tcp = probe->NewEndpoint(EndpointType_TCP);
    antModuleRef udp = probe->NewEndpoint(EndpointType_UDP);
    probe->Send(TCPEndpointListenMsg(tcp, kOtherIp, kPort));
    probe->Send(UDPEndpointBindMsg(udp, kOtherIp, kPort));
  });
  EXPECT_TRUE(Until([&] { return probe->replies.size() == 2; }));
  EXPECT_EQ(probe->replies, (std::vector<std::string>{
                                fmt::format("TCP Listen {}", static_cast<int>(TCP_ADDRESSERROR)),
                                fmt::format("UDP Bind {}", static_cast<int>(UDP_ADDRESSERROR))}));
}

TEST_F(AddressesTest, AnAddressThatThisComputerLacksIsSaid) {
  StartWith({{kOtherIp, 0xc0000201}});  // 192.0.2.1, an address that no computer has
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    probe->Send(TCPEndpointListenMsg(endpoint, kOtherIp, kPort));
  });
  EXPECT_TRUE(Until([&] { return !probe->replies.empty(); }));
  EXPECT_EQ(probe->replies[0], fmt::format("TCP Listen {}", static_cast<int>(TCP_ADDRESSERROR)));
  ASSERT_EQ(system->findings().all().size(), 1u);
  EXPECT_THAT(system->findings().all()[0].text,
              testing::StartsWith("a server port cannot be opened at 192.0.2.1: this computer has "
                                  "no such address"));
}

TEST_F(AddressesTest, ADatagramIsAnsweredFromTheAddressItWentTo) {
  HostPeer peer(NetProtocol::kUdp);
  ASSERT_EQ(BindSocket(peer.fd, {kLocal, 0}), 0);
  const uint16_t port = PortOf(peer.fd);
  StartWith({{kClientIp, kLocal}, {kOtherIp, kLocal}});
  NetAddress origin;
  probe->on_reply = [&](antEnvMsg* m) {
    if (m->GetOperation() != UDPEndpoint_Operation_Receive) return;
    const auto& got = *static_cast<UDPEndpointReceiveMsg*>(m);
    origin = {got.address.Address(), got.port};
  };
  Do([&] {
    byte* const buffer = probe->NewBuffer(100);
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_UDP);
    probe->Send(UDPEndpointBindMsg(endpoint, IP_ADDR_ANY, kPort));
    probe->Send(UDPEndpointSendMsg(endpoint, kOtherIp, port, buffer + 50, 3));
    probe->Send(UDPEndpointReceiveMsg(endpoint, buffer, 100));
  });
  EXPECT_TRUE(Until([&] { return peer.Hear(); }));
  SendDatagram(peer.fd, {kLocal, stack->HostPort(NetProtocol::kUdp, kPort)}, "x", 1);
  EXPECT_TRUE(Until([&] { return origin.port != 0; }));
  EXPECT_EQ(origin, (NetAddress{kOtherIp, port}));
}

TEST_F(AddressesTest, ADatagramSocketBoundToAnAddressIsFoundWhereThatIs) {
  StartWith({{kOtherIp, kSecondLocal}});
  Do([&] {
    byte* const buffer = probe->NewBuffer(100);
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_UDP);
    probe->Send(UDPEndpointBindMsg(endpoint, kOtherIp, kPort));
    probe->Send(UDPEndpointReceiveMsg(endpoint, buffer, 100));
  });
  HostPeer peer(NetProtocol::kUdp);
  SendDatagram(peer.fd, {kSecondLocal, stack->HostPort(NetProtocol::kUdp, kPort)}, "hi", 2);
  EXPECT_TRUE(Until([&] { return probe->replies.size() == 2; }));
  EXPECT_EQ(probe->replies[1], "UDP Receive 0 'hi'");
}

TEST_F(AddressesTest, NamesAreFoundAtTheAddressThatTheProgramKnows) {
  StartWith({{kClientIp, kLocal}});
  IPAddress found, asked;
  probe->on_reply = [&](antEnvMsg* m) {
    if (m->GetOperation() == DNSEndpoint_Operation_GetHostByName)
      found = static_cast<DNSEndpointGetHostByNameMsg*>(m)->host_address;
    if (m->GetOperation() == DNSEndpoint_Operation_GetHostByAddr)
      asked = static_cast<DNSEndpointGetHostByAddrMsg*>(m)->host_address;
  };
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_DNS);
    probe->Send(DNSEndpointGetHostByNameMsg(endpoint, "localhost."));
  });
  EXPECT_TRUE(Until([&] { return probe->replies.size() == 1; }));
  EXPECT_EQ(found, IPAddress(kClientIp));
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_DNS);
    probe->Send(DNSEndpointGetHostByAddrMsg(endpoint, kClientIp));
  });
  EXPECT_TRUE(Until([&] { return probe->replies.size() == 2; }));
  EXPECT_EQ(asked, IPAddress(kClientIp));
}

}  // namespace
}  // namespace openr_host
