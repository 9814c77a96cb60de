// A run is a function of its inputs: twice, and in pieces of any length.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "tests/graph/graph.h"

namespace openr_host {
namespace {

using Hashes = std::pair<uint64_t, uint64_t>;

Hashes HashesAfter(int64_t duration_us, int64_t slice_us, const GraphOptions& options) {
  Graph graph(options);
  while (graph.system().now_us() < duration_us) {
    graph.system().RunFor(std::min(slice_us, duration_us - graph.system().now_us()));
  }
  return {graph.system().trace_hash(), graph.system().state_hash()};
}

constexpr int64_t kStandUpUs = 15'000'000;

TEST(GraphDeterminismTest, TwoRunsAreEqual) {
  const GraphOptions ode;
  EXPECT_EQ(HashesAfter(kStandUpUs, kStandUpUs, ode), HashesAfter(kStandUpUs, kStandUpUs, ode));
}

TEST(GraphDeterminismTest, HowARunIsSlicedDoesNotShow) {
  const GraphOptions ode;
  const Hashes whole = HashesAfter(3'000'000, 3'000'000, ode);
  for (const int64_t slice_ms : {1, 8, 11, 1000}) {
    SCOPED_TRACE(fmt::format("slice_ms={}", slice_ms));
    EXPECT_EQ(HashesAfter(3'000'000, slice_ms * 1000, ode), whole);
  }
}

TEST(GraphDeterminismTest, TwentySeedsOnTheIdealBodyRepeatThemselves) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(fmt::format("seed={}", seed));
    GraphOptions ideal = kIdeal;
    ideal.seed = seed;
    EXPECT_EQ(HashesAfter(kStandUpUs, kStandUpUs, ideal),
              HashesAfter(kStandUpUs, kStandUpUs, ideal));
  }
}

// Two dogs in one process do not see each other.
TEST(GraphDeterminismTest, AnotherWorldInTheProcessDoesNotShow) {
  const GraphOptions ode;
  const Hashes alone = HashesAfter(2'000'000, 2'000'000, ode);
  Graph a(ode);
  Graph b(ode);
  for (int i = 0; i < 250; ++i) {
    a.system().RunFor(kFrameUs);
    b.system().RunFor(kFrameUs);
  }
  EXPECT_EQ(Hashes(a.system().trace_hash(), a.system().state_hash()), alone);
  EXPECT_EQ(Hashes(b.system().trace_hash(), b.system().state_hash()), alone);
}

}  // namespace
}  // namespace openr_host
