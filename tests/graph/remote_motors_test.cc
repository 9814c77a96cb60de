// Motors, gains and power over the remote control, with the four objects and a body with physics.
#include <OPENR/OPower.h>
#include <gtest/gtest.h>

#include "tests/graph/graph.h"
#include "tests/graph/remote_packets.h"

namespace openr_host {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const std::string kAllMotors(1, static_cast<char>(RC_ALL_JOINTS));
constexpr int kFirstLegJoint = 4;  // J1 of the left fore leg
constexpr int kTilt = 0;           // neck tilt: a limp head falls

// Sends a request and returns its answer.
HeardPacket AskRobot(Graph* graph, openr::testing::TcpClient* client, const std::string& packet) {
  const size_t heard = client->heard().size();
  client->Send(packet);
  graph->RunFor(milliseconds(100));
  const auto packets = RcHeard(client->heard().substr(heard));
  EXPECT_EQ(packets.size(), 1u);
  return packets.empty() ? HeardPacket{} : packets[0];
}

TEST(RemoteMotorsTest, AHeadWithoutMotorPowerSinksAndMotorOnHoldsItThere) {
  WhenStanding({}, [](Graph& graph) {
    auto& client = graph.AddClient();
    client.Connect(RC_PORT);
    const auto ask = [&](int command, const std::string& payload = "") {
      return AskRobot(&graph, &client, RcPacket(command, payload));
    };
    const auto tilt = [&] { return ask(rcSENSORS).Read<RcSensors>().joints[kTilt]; };
    const auto motor_power = [&] {
      return ask(rcPOWER).Read<RcPower>().robotStatus & orsbMOTOR_POWER;
    };
    EXPECT_NE(motor_power(), 0u);
    const Sint32 standing = tilt();
    EXPECT_EQ(ask(rcMOTOR_OFF, kAllMotors).status, rcOK);
    graph.RunFor(seconds(3));
    EXPECT_EQ(motor_power(), 0u);
    EXPECT_EQ(ask(rcGAINS, std::string(1, kFirstLegJoint)).Read<RcGains>().isOn, 0);
    const Sint32 limp = tilt();
    EXPECT_GT(std::abs(limp - standing), 1000) << "the head has sunk by more than 10 degrees";
    EXPECT_EQ(ask(rcMOVE, RcIndexAndValue(1, 1000)).status, rcerrorBUSY);
    EXPECT_EQ(ask(rcMOTOR_ON, kAllMotors).status, rcOK);
    graph.RunFor(seconds(1));
    EXPECT_NE(motor_power(), 0u);
    EXPECT_EQ(ask(rcGAINS, std::string(1, kFirstLegJoint)).Read<RcGains>().isOn, 1);
    EXPECT_LT(std::abs(tilt() - limp), 300) << "it holds where it hangs";
    EXPECT_EQ(ask(rcMOVE, RcIndexAndValue(1, 1000)).status, rcOK);
    graph.RunFor(seconds(2));
    EXPECT_NEAR(ask(rcSENSORS).Read<RcSensors>().joints[1], 1000, 200);
    EXPECT_EQ(graph.Findings(), "");
  });
}

TEST(RemoteMotorsTest, TheRobotHasTheGainsThatAClientSets) {
  WhenStanding(kIdeal, [](Graph& graph) {
    auto& client = graph.AddClient();
    client.Connect(RC_PORT);
    const std::string joint(1, kFirstLegJoint);
    const auto gains = [&](const std::string& payload) {
      return AskRobot(&graph, &client, RcPacket(rcGAINS, payload)).Read<RcGains>();
    };
    EXPECT_EQ(gains(joint).gain[0], 22);
    EXPECT_EQ(gains(joint + std::string("\x28\0\1\0\2\0", 6)).gain[0], 40);
    const RcGains now = gains(joint);
    EXPECT_EQ(now.isOn, 1);
    EXPECT_EQ(now.gain[0], 40);
    EXPECT_EQ(now.gain[1], 1);
    EXPECT_EQ(now.gain[2], 2);
    EXPECT_EQ(now.shift[0], 14);
  });
}

}  // namespace
}  // namespace openr_host
