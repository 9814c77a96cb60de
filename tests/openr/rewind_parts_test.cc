// Parts of Rewind, without a run that goes on.
#include <gmock/gmock.h>

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "openr/inspect/recorded_network.h"
#include "openr/rewind/branch_network.h"
#include "openr/rewind/input_log.h"
#include "openr/rewind/rewind.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;

// A network that keeps the sockets that wait for a connection.
class AcceptingNetwork : public ReplayedNetwork {
 public:
  AcceptingNetwork() : ReplayedNetwork([] { return std::vector<NetworkEvent>(); }) {}
  void Accept(NetHandle, NetHandle handle) override { accepts.push_back(handle); }
  void Forget() override { accepts.clear(); }

  std::vector<NetHandle> accepts;
};

TEST(BranchNetworkTest, ASocketThatWasDroppedWaitsForNoConnectionOfTheBranch) {
  auto inner = std::make_unique<AcceptingNetwork>();
  const AcceptingNetwork& sockets = *inner;
  InputLog log;
  BranchNetwork network(std::move(inner), 0, &log);
  network.Listen(1, 54000);
  network.Accept(1, 2);
  network.Accept(1, 3);
  network.Drop(2, false);
  network.Forget();
  network.GoOn();
  EXPECT_THAT(sockets.accepts, ElementsAre(3));
}

// Returns the number of inputs that are kept of a run to which somebody gives an input, and which
// cannot be rewound for the reason `why`.
uint64_t InputsKept(const std::string& why) {
  Rewind rewind;
  SimulationOptions options;
  options.stick = OPENR_STICK;
  options.body = "ideal";
  options.host_network = false;
  options.console = [](std::string_view) {};
  options.network_filter = [&rewind](int robot, std::unique_ptr<Network> inner) {
    return rewind.WrapNetwork(robot, std::move(inner));
  };
  Simulation simulation(options);
  RewindParts parts;
  parts.simulation = &simulation;
  parts.no_rewind_reason = why;
  rewind.Begin(std::move(parts));
  EXPECT_EQ(simulation.system().inputs().Add(0, "press chin"), "");
  return rewind.log().end();
}

TEST(RewindPartsTest, ARunThatCannotBeRewoundKeepsNoInputs) {
  EXPECT_EQ(InputsKept(""), 1u);
  EXPECT_EQ(InputsKept("it is connected to ROS 2 (--ros2)"), 0u);
}

}  // namespace
}  // namespace openr_host
