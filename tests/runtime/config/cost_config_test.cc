// Tests of cost files: which lines match a handler, and messages about bad lines.
#include <gtest/gtest.h>

#include <memory>

#include "runtime/core/configured_cost.h"
#include "tests/runtime/core/recorder.h"

namespace openr_host::cost_config_test {
namespace {

std::string ErrorIn(const std::string& text) {
  const CostResult result = ParseCostConfig("a.cost", text);
  return result.diagnostics.empty() ? "" : Render(result.diagnostics[0]);
}

TEST(CostConfigTest, ALineHasObjectEntryTimeAndJitter) {
  const CostResult result = ParseCostConfig("a.cost",
                                            "# comment\n"
                                            "* DoStart 20000\n"
                                            "B  B.In.Number.O (Notify)  1500  +-40%\n"
                                            "frame 8022\n");
  EXPECT_TRUE(result.diagnostics.empty());
  ASSERT_EQ(result.config.rules.size(), 2u);
  EXPECT_EQ(result.config.rules[0].object, "*");
  EXPECT_EQ(result.config.rules[0].cost_us, 20'000);
  EXPECT_EQ(result.config.rules[1].entry, "B.In.Number.O (Notify)");
  EXPECT_EQ(result.config.rules[1].jitter_percent, 40);
  EXPECT_EQ(result.config.frame_us, 8022);
}

TEST(CostConfigTest, WrongLinesAreShown) {
  EXPECT_EQ(ErrorIn("B DoStart\n"),
            "a.cost:1: object, entry or time missing; write: OBJECT ENTRY MICROSECONDS "
            "[+-JITTER%]\n"
            "B DoStart\n"
            "  ^");
  EXPECT_EQ(ErrorIn("B DoStart soon\n"),
            "a.cost:1: 'soon' is no time of 0 to 10000000 us; write: OBJECT ENTRY MICROSECONDS "
            "[+-JITTER%]\n"
            "B DoStart soon\n"
            "          ^");
  EXPECT_EQ(ErrorIn("B DoStart 100 50%\n"),
            "a.cost:1: '50%' is no jitter; write +-0% to +-100%, in one word\n"
            "B DoStart 100 50%\n"
            "              ^");
  EXPECT_EQ(ErrorIn("\nframe 8\n"),
            "a.cost:2: a frame lasts 1000 to 1000000 us; write: frame 8000\n"
            "frame 8\n"
            "      ^");
}

TEST(CostConfigTest, AStarIsAnyText) {
  EXPECT_TRUE(MatchesPattern("*", ""));
  EXPECT_TRUE(MatchesPattern("*.O (Notify)", "B.In.Number.O (Notify)"));
  EXPECT_TRUE(MatchesPattern("B*In*y)", "B.In.Number.O (Notify)"));
  EXPECT_TRUE(MatchesPattern("a*a*b", "aaab"));
  EXPECT_FALSE(MatchesPattern("B", "BB"));
  EXPECT_FALSE(MatchesPattern("*.S", "B.In.Number.O"));
}

class ConfiguredCostTest : public testing::Test {
 protected:
  explicit ConfiguredCostTest() {
    system.AddRobot("ERS-210", nullptr);
    object = system.AddObject<Recorder>(0, "a", &log);
  }
  int64_t CostOf(const std::string& text, uint64_t seed = 1) {
    ConfiguredCost cost(ParseCostConfig("a.cost", text).config, seed);
    return cost.CostUs(object->host(), object->entry);
  }

  Log log;
  System system;
  Recorder* object;
};

TEST_F(ConfiguredCostTest, TheLastLineThatFitsHolds) {
  EXPECT_EQ(CostOf(""), 0);
  EXPECT_EQ(CostOf("* * 10\na Entry 20\nb Entry 30\n"), 20);
  EXPECT_EQ(CostOf("a Entry 20\n* * 10\n"), 10);
}

TEST_F(ConfiguredCostTest, LinesThatFitNoHandlerAreKnown) {
  ConfiguredCost cost(
      ParseCostConfig("a.cost", "* * 10\na Entri 20\n# a\nb Entry 30\na Entry 40\n").config, 1);
  cost.CostUs(object->host(), object->entry);
  std::vector<int> lines;
  for (const FilePosition& place : cost.Unused()) lines.push_back(place.line);
  EXPECT_EQ(lines, (std::vector<int>{2, 4}));
  EXPECT_EQ(cost.Unused()[0].text, "a Entri 20");
}

TEST_F(ConfiguredCostTest, JitterStaysWithinItsShareAndRepeatsWithTheSeed) {
  const auto draw = [this](uint64_t seed) {
    ConfiguredCost cost(ParseCostConfig("a.cost", "* * 1000 +-20%\n").config, seed);
    std::vector<int64_t> costs;
    for (int i = 0; i < 1000; ++i) costs.push_back(cost.CostUs(object->host(), object->entry));
    return costs;
  };
  const auto costs = draw(7);
  EXPECT_EQ(costs, draw(7));
  EXPECT_NE(costs, draw(8));
  EXPECT_GE(*std::min_element(costs.begin(), costs.end()), 800);
  EXPECT_LT(*std::min_element(costs.begin(), costs.end()), 810);
  EXPECT_LE(*std::max_element(costs.begin(), costs.end()), 1200);
  EXPECT_GT(*std::max_element(costs.begin(), costs.end()), 1190);
}

}  // namespace
}  // namespace openr_host::cost_config_test
