// Tests of the choice of ports of the host, without sockets.
#include "runtime/ipstack/host_ports.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <vector>

namespace openr_host {
namespace {

// A host on which the ports in `taken` are in use; for port 0 it chooses 5555.
struct Host {
  int Bind(HostPorts* ports, uint16_t port) {
    const auto try_bind = [this](uint16_t wanted) {
      for (const uint16_t other : taken) {
        if (wanted == other) return EADDRINUSE;
      }
      bound = wanted == 0 ? uint16_t{5555} : wanted;
      return 0;
    };
    return ports->Bind(
        port, try_bind, [this] { return bound; }, &note);
  }
  std::vector<uint16_t> taken = {};
  uint16_t bound = 0;
  std::string note = {};
};

TEST(HostPortsTest, PortKeepsItsNumberWhenItIsFree) {
  HostPorts ports(NetProtocol::kTcp, {});
  Host host;
  EXPECT_EQ(host.Bind(&ports, 54000), 0);
  EXPECT_EQ(ports.HostPort(54000), 54000);
  EXPECT_EQ(host.note, "");
}

TEST(HostPortsTest, TakenPortIsReplacedByTheNextFreeOneWithANote) {
  HostPorts ports(NetProtocol::kUdp, {});
  Host host{{54000, 54001}};
  EXPECT_EQ(host.Bind(&ports, 54000), 0);
  EXPECT_EQ(ports.HostPort(54000), 54002);
  EXPECT_EQ(ports.RobotPort(54002), 54000);
  EXPECT_EQ(host.note,
            "UDP port 54000 of the robot is port 54002 of this computer: port 54000 cannot be had "
            "(Address already in use; another openr-host running?)");
}

TEST(HostPortsTest, ANoteBlamesNoOtherRunForAPortThatNeedsARight) {
  HostPorts ports(NetProtocol::kTcp, {});
  std::string note;
  const auto try_bind = [](uint16_t wanted) { return wanted == 0 ? 0 : EACCES; };
  EXPECT_EQ(ports.Bind(
                21, try_bind, [] { return uint16_t{5555}; }, &note),
            0);
  EXPECT_EQ(note,
            "TCP port 21 of the robot is port 5555 of this computer: port 21 cannot be had "
            "(Permission denied)");
}

TEST(HostPortsTest, WhereTheNextHundredAreTakenAnyFreeOneWillDo) {
  HostPorts ports(NetProtocol::kTcp, {});
  Host host;
  for (uint16_t port = 65500; port != 0; ++port) host.taken.push_back(port);
  EXPECT_EQ(host.Bind(&ports, 65500), 0);
  EXPECT_EQ(ports.HostPort(65500), 5555);
}

TEST(HostPortsTest, APortThatWasAskedForIsTakenOrNone) {
  HostPorts ports(NetProtocol::kTcp, {{54000, 8000}});
  Host host{{8000}};
  EXPECT_EQ(host.Bind(&ports, 54000), EADDRINUSE);
  EXPECT_EQ(ports.HostPort(54000), 0);
  EXPECT_EQ(host.note,
            "TCP port 54000 of the robot is nowhere: port 8000 of this computer, which was asked "
            "for, cannot be had (Address already in use)");
  host.taken.clear();
  EXPECT_EQ(host.Bind(&ports, 54000), 0);
  EXPECT_EQ(ports.HostPort(54000), 8000);
}

TEST(HostPortsTest, AnyFreePortIsTakenSilentlyWhenWishedFor) {
  HostPorts ports(NetProtocol::kTcp, {{54000, 0}});
  Host host;
  EXPECT_EQ(host.Bind(&ports, 54000), 0);
  EXPECT_EQ(ports.HostPort(54000), 5555);
  EXPECT_EQ(host.note, "");
}

TEST(HostPortsTest, PortOnceChosenIsTriedFirstTheNextTime) {
  HostPorts ports(NetProtocol::kTcp, {{54000, 0}});
  Host host;
  host.Bind(&ports, 54000);
  host.bound = 0;
  EXPECT_EQ(host.Bind(&ports, 54000), 0);
  EXPECT_EQ(host.bound, 5555);
}

TEST(HostPortsTest, HostWithoutAnyPortIsAnError) {
  HostPorts ports(NetProtocol::kTcp, {});
  Host host{{0}};
  for (uint16_t port = 54000; port <= 54000 + HostPorts::kNextPorts; ++port)
    host.taken.push_back(port);
  EXPECT_EQ(host.Bind(&ports, 54000), EADDRINUSE);
  EXPECT_EQ(ports.HostPort(54000), 0);
}

}  // namespace
}  // namespace openr_host
