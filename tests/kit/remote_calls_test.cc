// A program on a PC that makes the robot of another run stand: examples/StandUp, unchanged.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Ports of loopback that nobody has.
std::vector<std::string> FreePorts(size_t count) {
  std::vector<std::string> ports;
  std::vector<int> sockets;
  for (size_t i = 0; i < count; ++i) {
    const int s = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    bind(s, reinterpret_cast<sockaddr*>(&address), size);
    getsockname(s, reinterpret_cast<sockaddr*>(&address), &size);
    ports.push_back(std::to_string(ntohs(address.sin_port)));
    sockets.push_back(s);
  }
  for (const int s : sockets) close(s);
  return ports;
}

TEST(RemoteCallsTest, AProgramOnAPcMakesTheRobotOfAnotherRunStand) {
  const std::vector<std::string> ports = FreePorts(2);
  const KitFolder pc(""), robot("");
  fs::copy(OPENR_EXAMPLE_CONTROLLERS "/../StandUp", pc.File(""), fs::copy_options::recursive);
  const ProgramResult built = pc.Build();
  ASSERT_EQ(built.status, 0) << built.err;
  const std::string conf = "MS/OPEN-R/MW/CONF/";
  pc.Write(conf + "OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/STANDUP.BIN\n");
  pc.Write(conf + "CONNECT.CFG",
           "StandUp.Move.OCommandVectorData.S TCPGateway.Effector.OCommandVectorData.O\n");
  // As of that time: the address is that of the dog.
  pc.Write(conf + "HOSTGW.CFG", "!ROBOT_PROXY " + ports[0] +
                                    " 10.0.1.100\nTCPGateway.Effector.OCommandVectorData.O " +
                                    ports[1] + " 10.0.1.100\n");
  EXPECT_THAT(
      RunProgram({"check", pc.File("")}).out,
      HasSubstr("HOSTGW.CFG:1: note: a robot that openr runs on this computer is 127.0.0.1: "
                "write that, or run with --ip 10.0.1.100=127.0.0.1"));

  robot.Write(conf + "OBJECT.CFG",
              "/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n/MS/OPEN-R/SYSTEM/OBJS/TCPGW.BIN\n");
  robot.Write(conf + "CONNECT.CFG",
              "TCPGateway.Effector.OCommandVectorData.S "
              "OVirtualRobotComm.Effector.OCommandVectorData.O\n");
  robot.Write(conf + "ROBOTGW.CFG", "TCPGateway.Proxy.AperiosMessage.P " + ports[0] +
                                        "\nTCPGateway.Effector.OCommandVectorData.S " + ports[1] +
                                        "\n");
  fs::create_directories(robot.File("MS/OPEN-R/MW/OBJS"));
  fs::copy(OPENR_BUILD "/stick/OPEN-R/MW/OBJS/POWERMON.BIN",
           robot.File("MS/OPEN-R/MW/OBJS/POWERMON.BIN"));

  ProgramRun dog(
      {"run", "--stick", robot.File("MS"), "--no-panel", "--rate", "3", "--for", "40s", "--json"});
  ASSERT_TRUE(dog.WaitFor("tcpGateway")) << dog.Finish().err;
  const std::string recording = pc.File("pc.rec");
  ProgramRun program({"run", "--stick", pc.File("MS"), "--no-panel", "--rate", "1", "--ip",
                      "10.0.1.100=127.0.0.1", "--record", recording});
  EXPECT_TRUE(program.WaitFor("StandUp: done"));
  program.Signal(SIGINT);
  const ProgramResult said = program.Finish();
  EXPECT_EQ(said.status, 0) << said.err;
  const ProgramResult ended = dog.Finish();
  ASSERT_EQ(ended.status, 0) << ended.err;
  const nlohmann::json report = nlohmann::json::parse(ended.out);
  EXPECT_TRUE(report["robots"][0]["standing"]);
  const ProgramResult replayed = RunProgram({"replay", recording});
  EXPECT_EQ(replayed.status, 0) << replayed.err;
}

}  // namespace
}  // namespace openr_host
