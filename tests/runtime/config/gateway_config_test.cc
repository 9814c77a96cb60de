#include "runtime/config/gateway_config.h"

#include <gtest/gtest.h>

#include "runtime/config/line_file.h"

namespace openr_host::gateway_config_test {
namespace {

GatewayConfig Robot(std::string_view text, std::string_view design = "ERS-210") {
  return ParseGatewayConfig("ROBOTGW.CFG", text, design, GatewaySide::kRobot);
}
GatewayConfig Host(std::string_view text) {
  return ParseGatewayConfig("HOSTGW.CFG", text, "ERS-210", GatewaySide::kHost);
}
std::string ErrorIn(const GatewayConfig& config) {
  return config.diagnostics.empty() ? "" : Render(config.diagnostics[0]);
}

TEST(GatewayConfigTest, RobotSideGivesEachServiceAPort) {
  const GatewayConfig config = Robot(
      "# ports\r\nTCPGateway.Sensor.Frame.O 59002\r\n\tTCPGateway.Effector.Vector.S\t59003  ");
  ASSERT_EQ(config.services.size(), 2u);
  EXPECT_EQ(Compose(config.services[0].service), "TCPGateway.Sensor.Frame.O");
  EXPECT_EQ(config.services[0].port, 59002);
  EXPECT_EQ(config.services[1].port, 59003);
  EXPECT_EQ(config.services[1].host, "");
  EXPECT_EQ(Render(config.diagnostics), "");
}

TEST(GatewayConfigTest, HostSideNamesTheRobotToo) {
  const GatewayConfig config = Host("TCPGateway.Sensor.Frame.S 59002 10.0.1.100\n");
  ASSERT_EQ(config.services.size(), 1u);
  EXPECT_EQ(config.services[0].host, "10.0.1.100");
}

TEST(GatewayConfigTest, OnlySectionsOfTheRobotHold) {
  EXPECT_EQ(Robot("[ERS-7]\nTCPGateway.a.T.O 59002\n").services.size(), 0u);
  EXPECT_EQ(
      Robot("[ERS-210]\nTCPGateway.a.T.O 59002\n[ERS-7]\nTCPGateway.a.T.O 59002\n", kEveryDesign)
          .services.size(),
      2u);
}

TEST(GatewayConfigTest, AnAddressInTheRobotsFileGetsAHint) {
  EXPECT_EQ(
      ErrorIn(Robot("TCPGateway.a.T.O 59002 10.0.1.100\n")),
      "ROBOTGW.CFG:1: '10.0.1.100' after the record; a line holds a service and a port; "
      "addresses are in the PC's HOSTGW.CFG, where a robot that openr runs on this computer is "
      "127.0.0.1; the service is not there\n"
      "TCPGateway.a.T.O 59002 10.0.1.100\n"
      "                       ^");
}

TEST(GatewayConfigTest, OpenrCallsHaveAPortAndOnThePcAnAddress) {
  const GatewayConfig robot = Robot("TCPGateway.Proxy.AperiosMessage.P 59001\n");
  EXPECT_EQ(Render(robot.diagnostics), "");
  ASSERT_TRUE(robot.proxy.has_value());
  EXPECT_EQ(robot.proxy->port, 59001);
  EXPECT_EQ(robot.proxy->Name(), "TCPGateway.Proxy.AperiosMessage.P");
  EXPECT_TRUE(robot.services.empty());
  const GatewayConfig host = Host("!ROBOT_PROXY 59001 10.0.1.100\n");
  EXPECT_EQ(Render(host.diagnostics), "");
  ASSERT_TRUE(host.proxy.has_value());
  EXPECT_EQ(host.proxy->host, "10.0.1.100");
}

TEST(GatewayConfigTest, OpenrCallsOfTheOtherSideAreAWarning) {
  EXPECT_EQ(ErrorIn(Robot("!ROBOT_PROXY 59001 10.0.1.100\n")),
            "ROBOTGW.CFG:1: warning: OPEN-R calls are not carried: '!ROBOT_PROXY' belongs to the "
            "PC's file, this file has 'TCPGateway.Proxy.AperiosMessage.P PORT'\n"
            "!ROBOT_PROXY 59001 10.0.1.100\n"
            "^");
  EXPECT_EQ(ErrorIn(Host("TCPGateway.Proxy.AperiosMessage.P 59001\n")).substr(0, 116),
            "HOSTGW.CFG:1: warning: OPEN-R calls are not carried: "
            "'TCPGateway.Proxy.AperiosMessage.P' belongs to the robot's file");
}

TEST(GatewayConfigTest, OpenrCallsShareTheirPortWithNobody) {
  EXPECT_EQ(ErrorIn(Robot("TCPGateway.Proxy.AperiosMessage.P 59001\nTCPGateway.a.T.O 59001\n"))
                .substr(0, 82),
            "ROBOTGW.CFG:2: port 59001 is that of 'TCPGateway.Proxy.AperiosMessage.P' in line 1");
  EXPECT_EQ(
      ErrorIn(Host("!ROBOT_PROXY 59001 10.0.1.100\n!ROBOT_PROXY 59005 10.0.1.100\n")).substr(0, 56),
      "HOSTGW.CFG:2: OPEN-R calls have a port already, in line ");
  EXPECT_EQ(ErrorIn(Host("!ROBOT_PROXY 59001 dog\n")).substr(0, 34),
            "HOSTGW.CFG:1: 'dog' is no address;");
}

TEST(GatewayConfigTest, UnknownConfigurationRecordIsNamed) {
  EXPECT_EQ(ErrorIn(Host("!ROBOT_PROXI 59001 10.0.1.100\n")),
            "HOSTGW.CFG:1: warning: '!ROBOT_PROXI' is not known; there is !ROBOT_PROXY only; did "
            "you mean '!ROBOT_PROXY'?\n"
            "!ROBOT_PROXI 59001 10.0.1.100\n"
            "^");
}

TEST(GatewayConfigTest, PortMustBeOne) {
  for (const char* port : {"0", "65536", "-1", "59002x", "0x10", "http"}) {
    const GatewayConfig config = Robot(std::string("TCPGateway.a.T.O ") + port + "\n");
    EXPECT_TRUE(config.services.empty()) << port;
    EXPECT_TRUE(HasErrors(config.diagnostics)) << port;
  }
  EXPECT_EQ(ErrorIn(Robot("TCPGateway.a.T.O 70000\n")),
            "ROBOTGW.CFG:1: '70000' is no port; write a number of 1 to 65535; the service is not "
            "there\n"
            "TCPGateway.a.T.O 70000\n"
            "                 ^");
}

TEST(GatewayConfigTest, PortOfTheConsoleIsAWarning) {
  const GatewayConfig config = Robot("TCPGateway.a.T.O 59000\n");
  EXPECT_EQ(config.services.size(), 1u);
  EXPECT_NE(ErrorIn(config).find("port 59000 belongs to the wireless console"), std::string::npos);
}

TEST(GatewayConfigTest, ServicesPairByPortSoNoPortIsGivenTwice) {
  EXPECT_EQ(ErrorIn(Robot("TCPGateway.a.T.O 59002\nTCPGateway.b.T.O 59002\n")),
            "ROBOTGW.CFG:2: port 59002 is that of 'TCPGateway.a.T.O' in line 1; the two sides pair "
            "by port; the service is not there\n"
            "TCPGateway.b.T.O 59002\n"
            "                 ^");
  EXPECT_EQ(Host("TCPGateway.a.T.O 59002 10.0.1.100\nTCPGateway.b.T.O 59002 10.0.1.101\n")
                .services.size(),
            2u);
}

TEST(GatewayConfigTest, ServiceIsGivenOnce) {
  EXPECT_NE(ErrorIn(Robot("TCPGateway.a.T.O 59002\nTCPGateway.a.T.O 59003\n"))
                .find("ROBOTGW.CFG:2: the service is given already in line 1"),
            std::string::npos);
}

TEST(GatewayConfigTest, RecordsHaveTheirWords) {
  EXPECT_NE(ErrorIn(Robot("TCPGateway.a.T.O\n")).find("a line holds a service and a port"),
            std::string::npos);
  EXPECT_NE(ErrorIn(Robot("TCPGateway.a.T.O 59002 data\n")).find("'data' after the record"),
            std::string::npos);
  EXPECT_NE(ErrorIn(Host("TCPGateway.a.T.S 59002\n"))
                .find("a line holds a service, a port and an address"),
            std::string::npos);
  EXPECT_NE(ErrorIn(Host("TCPGateway.a.T.S 59002 mydog\n")).find("'mydog' is no address"),
            std::string::npos);
  EXPECT_NE(ErrorIn(Host("TCPGateway.a.T.S 59002 0.0.0.0\n")).find("'0.0.0.0' is no address"),
            std::string::npos);
  EXPECT_NE(ErrorIn(Robot("TCPGateway.a.T 59002\n")).find("has 3 parts"), std::string::npos);
}

// ---- wires

std::string WiresError(std::string_view wires) {
  const auto diagnostics = CheckGatewayWires(
      ParseConnectConfig("CONNECT.CFG", wires, kEveryDesign),
      Robot("TCPGateway.Sensor.T.O 59002\nTCPGateway.Effector.T.S 59003\n"), "ROBOTGW.CFG");
  return diagnostics.empty() ? "" : Render(diagnostics[0]);
}

TEST(GatewayWiresTest, OneWireOfEachServiceIsFine) {
  EXPECT_EQ(WiresError("A.x.T.S TCPGateway.Sensor.T.O\nTCPGateway.Effector.T.S B.y.T.O\n"
                       "A.x.T.S B.y.T.O\nA.x.T.S C.y.T.O\n"),
            "");
}

TEST(GatewayWiresTest, SecondWireOfAServiceFailsOnTheRobot) {
  EXPECT_EQ(WiresError("A.x.T.S TCPGateway.Sensor.T.O\nB.x.T.S TCPGateway.Sensor.T.O\n"),
            "CONNECT.CFG:2: 'TCPGateway.Sensor.T.O' is connected already in line 1; a service of "
            "the gateway carries one connection, more fail on the robot: give each its own service "
            "and port\n"
            "B.x.T.S TCPGateway.Sensor.T.O\n"
            "        ^");
  EXPECT_NE(WiresError("TCPGateway.Effector.T.S B.x.T.O\nTCPGateway.Effector.T.S B.y.T.O\n"), "");
}

TEST(GatewayWiresTest, WiresOfOtherRobotsDoNotCount) {
  EXPECT_EQ(WiresError("[ERS-210]\nA.x.T.S TCPGateway.Sensor.T.O\n"
                       "[ERS-7]\nB.x.T.S TCPGateway.Sensor.T.O\n"),
            "");
}

TEST(GatewayWiresTest, ServiceThatTheGatewayDoesNotHave) {
  EXPECT_EQ(WiresError("A.x.T.S TCPGateway.Sensr.T.O\n"),
            "CONNECT.CFG:1: the gateway has no 'TCPGateway.Sensr.T.O': it is not in ROBOTGW.CFG; "
            "did you mean 'TCPGateway.Sensor.T.O'?\n"
            "A.x.T.S TCPGateway.Sensr.T.O\n"
            "        ^");
}

}  // namespace
}  // namespace openr_host::gateway_config_test
