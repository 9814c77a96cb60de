// The view of a graph, which openr graph draws.
#include "openr/graph/graph_view.h"

#include <gtest/gtest.h>

#include "runtime/core/subject_state.h"
#include "testing/bench.h"

namespace openr::testing {
namespace {

TEST(GraphViewTest, ARefusedConnectionIsNotTakenForTheOneAfterIt) {
  Bench bench;
  ProbeSubject& say = bench.AddProbe("A", {"A.Say.Text.S"}).subject("Say");
  for (const std::string name : {"B", "C"}) {
    bench.AddProbe(name, {name + ".Hear.Text.O"});
    bench.Wire("A.Say.Text.S", name + ".Hear.Text.O");
  }
  bench.Boot();
  say.SendText("one");
  bench.RunFor(8ms);
  // Leaves A's record of B out, as A has it after it has refused B.
  auto& links = bench.object("A").subjects().front()->links;
  ASSERT_EQ(links.size(), 2u);
  links.erase(links.begin());
  const openr_host::GraphView graph = openr_host::CollectGraph(&bench.system());
  ASSERT_EQ(graph.connections.size(), 2u);
  EXPECT_FALSE(graph.connections[0].connected);
  EXPECT_EQ(graph.connections[0].events, 0u);
  EXPECT_TRUE(graph.connections[1].connected);
  EXPECT_EQ(graph.connections[1].events, 1u);
}

}  // namespace
}  // namespace openr::testing
