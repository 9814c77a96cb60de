// RCServer while its TCP port cannot be had: it tries again each second, with new endpoints.
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "RemotePacket.h"
#include "openr/simulation/run_stick.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/ipstack/loopback_network.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

// A network on which Listen() fails while `*is_busy` is true.
class BusyPortNetwork : public LoopbackNetwork {
 public:
  BusyPortNetwork(std::shared_ptr<LoopbackHub> hub, const bool* is_busy)
      : LoopbackNetwork(std::move(hub)), is_busy_(*is_busy) {}

  void Listen(NetHandle listener, uint16_t port) override {
    if (!is_busy_) return LoopbackNetwork::Listen(listener, port);
    failed_.push_back(listener);
  }
  std::vector<NetworkEvent> Poll() override {
    std::vector<NetworkEvent> events = LoopbackNetwork::Poll();
    for (const NetHandle listener : std::exchange(failed_, {})) {
      NetworkEvent event;
      event.kind = NetworkEvent::Kind::kFailed;
      event.handle = listener;
      event.error = NetError::kAddressInUse;
      events.push_back(event);
    }
    return events;
  }

 private:
  const bool& is_busy_;
  std::vector<NetHandle> failed_;
};

TEST(BusyPortTest, RcServerListensWhenItsPortIsFreeAgainAfterAMinute) {
  const ScratchFolder folder;
  CopyStick(OPENR_STICK, folder.path());
  const auto hub = std::make_shared<LoopbackHub>();
  bool is_busy = true;
  SimulationOptions options;
  options.stick = folder.path();
  options.body = "ideal";
  options.host_network = false;
  options.console = [](std::string_view) {};
  options.network_filter = [&](int, std::unique_ptr<Network>) -> std::unique_ptr<Network> {
    return std::make_unique<BusyPortNetwork>(hub, &is_busy);
  };
  Simulation simulation(options);
  ASSERT_TRUE(simulation.loaded());
  System& system = simulation.system();
  system.Boot();
  system.RunFor(60'000'000);
  IpStack* const stack = IpStack::Of(&system, 0);
  ASSERT_NE(stack, nullptr);
  EXPECT_LE(stack->endpoint_count(), 8u) << "endpoints that could not listen are closed";

  is_busy = false;
  system.RunFor(2'000'000);
  EXPECT_EQ(stack->endpoint_count(), 8u);
  LoopbackNetwork client(hub);
  client.Attach(0x0a000199);
  client.Connect(1, 50000, {stack->address(), RC_PORT});
  const std::vector<NetworkEvent> events = client.Poll();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, NetworkEvent::Kind::kConnected);
}

}  // namespace
}  // namespace openr_host
