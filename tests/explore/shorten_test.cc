// Shortening: what is left breaks, and nothing less does.
#include "openr/explore/shorten.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

Json Ties(int count) {
  Json script = Json::array();
  for (int i = 0; i < count; ++i) script.push_back({{"kind", "tie"}, {"nth", i}});
  return script;
}

// Breaks when all of `needed` are there.
StillBreaks Needs(const std::set<int>& needed) {
  return [needed](const Json& script) -> std::optional<Json> {
    std::set<int> there;
    for (const Json& line : script) there.insert(line["nth"].get<int>());
    for (const int nth : needed) {
      if (!there.contains(nth)) return {};
    }
    return Json{{"size", script.size()}};
  };
}

TEST(ShortenTest, FindsTheFewThatMatterAmongMany) {
  Json script = Ties(1000), answer;
  const int runs = Shorten(Needs({3, 500, 998}), 2000, &script, &answer);
  EXPECT_EQ(script, Json::parse(R"([{"kind":"tie","nth":3},{"kind":"tie","nth":500},
                                    {"kind":"tie","nth":998}])"));
  EXPECT_EQ(answer["size"], 3);
  EXPECT_LT(runs, 200);
}

TEST(ShortenTest, AFaultOfTheCanonicalOrderNeedsOneRun) {
  Json script = Ties(1000), answer;
  EXPECT_EQ(Shorten(Needs({}), 2000, &script, &answer), 1);
  EXPECT_TRUE(script.empty());
}

TEST(ShortenTest, NoMoreRunsThanAllowed) {
  Json script = Ties(1000), answer;
  EXPECT_EQ(Shorten(Needs({1, 700}), 5, &script, &answer), 5);
  EXPECT_TRUE(Needs({1, 700})(script).has_value());
}

TEST(ShortenTest, DelaysBecomeAsSmallAsHalvingMakesThem) {
  Json script = {{{"kind", "delay"}, {"nth", 0}, {"us", 40'000}}}, answer;
  const auto breaks = [](const Json& candidate) -> std::optional<Json> {
    if (candidate.empty() || candidate[0]["us"] < 3'000) return {};
    return candidate[0];
  };
  Shorten(breaks, 100, &script, &answer);
  EXPECT_EQ(script[0]["us"], 5'000);
}

}  // namespace
}  // namespace openr_host
