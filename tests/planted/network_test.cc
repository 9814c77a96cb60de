// Faults that the network hides until the robot is busy (field-notes.md, 11.6).
#include <EndpointTypes.h>
#include <UDPEndpointMsg.h>
#include <ant.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "runtime/ipstack/ip_stack.h"
#include "runtime/ipstack/loopback_network.h"
#include "tests/planted/planted.h"

namespace openr_host::network_test {
namespace {

constexpr uint32_t kRobotIp = 0x0a000164;  // 10.0.1.100, the default of WLANCONF.TXT
constexpr uint16_t kPort = 54321;

// Fault: gives up when data of the network take longer than 50 ms.  The data are a datagram that it
// sends to its own port.
class HurriedListener : public Actor {
 public:
  HurriedListener() {
    done_ = AddExtra("Done", [](void*) {});
    received_ = AddExtra("Received", [this](void* message) {
      const auto* const receive = static_cast<UDPEndpointReceiveMsg*>(antEnvMsg::Receive(message));
      has_data_ = receive->error == UDP_SUCCESS;
    });
    begin_ = AddExtra("Begin", [this](void*) { Begin(); });
    check_ = AddExtra("Check", [this](void*) { Say(has_data_ ? "received" : "gave up"); });
  }

  OStatus DoStart(const OSystemEvent&) override {
    antEnvCreateSharedBufferMsg create(2 * kBytes);
    create.Call(antStackRef("IPStack"), sizeof create);
    create.buffer.Map();
    buffer_ = static_cast<byte*>(create.buffer.GetAddress());
    antEnvCreateEndpointMsg endpoint(EndpointType_UDP, 4096);
    endpoint.Call(antStackRef("IPStack"), sizeof endpoint);
    endpoint_ = endpoint.moduleRef;
    Ask(UDPEndpointBindMsg(endpoint_, IP_ADDR_ANY, kPort), done_);
    Post(host().id, begin_, 500'000);
    return oSUCCESS;
  }

 private:
  static constexpr int kBytes = 16;

  template <typename Message>
  void Ask(Message message, Selector answer) {
    message.Send(antStackRef("IPStack"), myOID_, static_cast<int32>(answer), sizeof message);
  }

  void Begin() {
    Ask(UDPEndpointReceiveMsg(endpoint_, buffer_, kBytes), received_);
    Ask(UDPEndpointSendMsg(endpoint_, kRobotIp, kPort, buffer_ + kBytes, kBytes), done_);
    Post(host().id, check_, 50'000);
  }

  Selector done_, received_, begin_, check_;
  antModuleRef endpoint_;
  byte* buffer_ = nullptr;
  bool has_data_ = false;
};

TEST(PlantedNetworkTest, DataThatAreExpectedTooSoonAreFoundWithASlowNetwork) {
  const auto build = [](System* system) {
    AddIpStack(system, 0, std::make_shared<LoopbackNetwork>());
    system->AddObject<HurriedListener>(0, "listener");
  };
  ExplorePlan plan = PlanOf(SceneOf(build), {"always objects.listener.state != gave up",
                                             "eventually within 1s objects.listener.state == "
                                             "received"});
  EXPECT_EQ(InDefaultOrder(plan).text, "");
  const Broken broken = InRandomOrders(plan);
  ASSERT_EQ(broken.deviations, 1u) << broken.failure.dump(1);
  const Json& delay = broken.failure["deviations"][0];
  EXPECT_EQ(delay["kind"], "delay");
  EXPECT_EQ(delay["sender"], "IPStack");
  EXPECT_EQ(delay["entry"], "Received");
  // The data come at the frame boundary 504 ms without delay, and the listener gives up at 550 ms.
  // The delay was halved as long as it still broke the property.
  EXPECT_GE(delay["us"].get<int64_t>(), 46'000);
  EXPECT_LT(delay["us"].get<int64_t>(), 92'001);
  plan.run.vary.network = false;
  EXPECT_EQ(InRandomOrders(plan).text, "");
}

}  // namespace
}  // namespace openr_host::network_test
