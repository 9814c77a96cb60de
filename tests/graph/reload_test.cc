// A controller is replaced while the dog stands: hot upload of CONTROLL.BIN.
#include <gtest/gtest.h>

#include "tests/graph/graph.h"

namespace openr_host {
namespace {

TEST(ReloadTest, TheControllerIsReplacedAndTheDogGoesOnStanding) {
  WhenStanding({}, [](Graph& graph) {
    const ObjectId id = graph.system().FindObject(0, "Controller")->id;
    const uint64_t before = graph.system().object(id)->message_count();
    graph.system().object_table().Reload(id);
    graph.system().RunFor(2'000'000);
    EXPECT_EQ(graph.Findings(), "");
    EXPECT_GT(graph.system().object(id)->message_count(), before + 50);  // sensors arrive
    EXPECT_EQ(graph.system().object(id)->statistics().state(), "running");
    EXPECT_TRUE(graph.Standing());
  });
}

TEST(ReloadTest, RcServerListensAgainAfterItWasReplaced) {
  WhenStanding(kIdeal, [](Graph& graph) {
    const ObjectId id = graph.system().FindObject(0, "RCServer")->id;
    graph.system().object_table().Reload(id);
    graph.system().RunFor(1'000'000);
    EXPECT_EQ(graph.Findings(), "");
    EXPECT_EQ(graph.system().object(id)->statistics().state(), "listening");
  });
}

}  // namespace
}  // namespace openr_host
