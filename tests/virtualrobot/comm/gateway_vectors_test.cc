// Command vectors and sounds that a program elsewhere sends through TCPGateway: their headers
// name memory of that program's machine.
#include <gtest/gtest.h>

#include "runtime/gateway/tcp_gateway.h"
#include "tests/runtime/gateway/gateway_bytes.h"
#include "tests/runtime/ipstack/net_probe.h"
#include "tests/virtualrobot/sound/sound_fixture.h"

namespace openr_host {
namespace {

constexpr uint16_t kEffectorPort = 59003, kSpeakerPort = 59004;

// Sends on what it receives, in the same memory.
class PassingOn : public CodeObject {
 public:
  PassingOn() {
    out = AddSubject("PassingOn.Out.OCommandVectorData.S");
    in = AddObserver("PassingOn.In.OCommandVectorData.O", [this](const ONotifyEvent& event) {
      out->SetData(event.RCData(0));
      out->NotifyObservers();
      in->AssertReady();
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    in->AssertReady();
    return oSUCCESS;
  }
  OSubject* out;
  OObserver* in;
};

class GatewayVectorsTest : public SoundTest {
 protected:
  GatewayVectorsTest() {
    AddIpStack(&system, dog, std::make_unique<LoopbackNetwork>(hub));
    const auto service = [](const char* name, uint16_t port) {
      GatewayRecord record;
      record.service = *ParseServiceName(name, nullptr);
      record.port = port;
      return record;
    };
    GatewayConfig config;
    config.services = {service("TCPGateway.Effector.OCommandVectorData.S", kEffectorPort),
                       service("TCPGateway.Speaker.OSoundVectorData.S", kSpeakerPort)};
    system.AddObject<TcpGateway>(dog, TcpGateway::kName, config);
    system.Connect({dog, "TCPGateway.Speaker.OSoundVectorData.S",
                    "OVirtualRobotAudioComm.Speaker.OSoundVectorData.O", "test"});
  }
  void Connect(const char* subject, const char* observer) {
    system.Connect({dog, subject, observer, "test"});
  }
  // The bytes of a vector as another machine sends them.
  static std::string BytesFromElsewhere(RCRegion* region) {
    reinterpret_cast<ODataVectorInfo*>(region->Base())->memRegionID = 0x7654321;
    return std::string(region->Base(), region->Size());
  }
  void SayFromElsewhere(uint16_t port, const std::string& bytes) {
    peer.Connect(port);
    Frames(4);
    ASSERT_EQ(peer.heard, kReadyWord);
    peer.Say(OneItem(bytes));
    Frames(8);
  }
  void Frames(int count) {
    for (int i = 0; i < count; ++i) {
      system.RunFor(kFrameUs);
      peer.Poll();
    }
  }
  std::string PanVector() {
    std::string bytes;
    As([&] {
      RCRegion* const region = mover->NewVector(1);
      Mover::FillJoint(region, 0, mover->Open(kPan), {7});
      bytes = BytesFromElsewhere(region);
    });
    return bytes;
  }

  std::shared_ptr<LoopbackHub> hub = std::make_shared<LoopbackHub>();
  Peer peer{hub};
};

TEST_F(GatewayVectorsTest, CommandsArePlayedAndTheirMemoryIsNoFinding) {
  Connect("TCPGateway.Effector.OCommandVectorData.S",
          "OVirtualRobotComm.Effector.OCommandVectorData.O");
  Boot();
  SayFromElsewhere(kEffectorPort, PanVector());
  EXPECT_EQ(Pan(), 7);
  EXPECT_EQ(Findings(), "");
}

TEST_F(GatewayVectorsTest, NorAreCommandsThatAnObjectPassesOn) {
  system.AddObject<PassingOn>(dog, "passingOn");
  Connect("TCPGateway.Effector.OCommandVectorData.S", "PassingOn.In.OCommandVectorData.O");
  Connect("PassingOn.Out.OCommandVectorData.S", "OVirtualRobotComm.Effector.OCommandVectorData.O");
  Boot();
  SayFromElsewhere(kEffectorPort, PanVector());
  EXPECT_EQ(Pan(), 7);
  EXPECT_EQ(Findings(), "");
}

TEST_F(GatewayVectorsTest, SoundsArePlayedAndTheirMemoryIsNoFinding) {
  BootForSound();
  std::string bytes;
  RunAs(player, [&] { bytes = BytesFromElsewhere(player->NewSound(64, 1)); });
  SayFromElsewhere(kSpeakerPort, bytes);
  ASSERT_EQ(sink->entries.size(), 1u);
  EXPECT_EQ(sink->entries[0].samples.front(), 256);
  EXPECT_EQ(Findings(), "");
}

}  // namespace
}  // namespace openr_host
