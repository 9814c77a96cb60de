// Parts of Rewind, without a run that goes on.
#include <gmock/gmock.h>

#include <memory>
#include <utility>
#include <vector>

#include "openr/inspect/recorded_network.h"
#include "openr/rewind/branch_network.h"
#include "openr/rewind/input_log.h"

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

}  // namespace
}  // namespace openr_host
