#include "cli/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace openr_host {
namespace {

using Json = nlohmann::json;

std::string Problem(const std::string& text, Fractions fractions) {
  try {
    CheckFractions(ParseJson<Json>(text), fractions);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(JsonTextTest, WholeNumbersAreAlwaysAccepted) {
  const std::string text = R"({"a":[0,-9223372036854775808,18446744073709551615],"b":"1e30"})";
  EXPECT_EQ(Problem(text, Fractions::kNone), "");
  EXPECT_EQ(Problem(text, Fractions::kBounded), "");
  EXPECT_EQ(JsonText(ParseJson<Json>(text)), text);
}

TEST(JsonTextTest, AFractionIsRefusedWhereAllNumbersAreWhole) {
  EXPECT_EQ(Problem(R"({"a":[1,{"b":0.5}]})", Fractions::kNone),
            "the number 0.5 is no whole number");
  // More digits than 64 bits have: the JSON library reads this as a fraction.
  EXPECT_EQ(Problem("43101900000000000000", Fractions::kNone),
            "the number 4.31019e+19 is no whole number");
}

TEST(JsonTextTest, AFractionBeyondEveryIntegerIsRefused) {
  EXPECT_EQ(Problem("[0.5,-2147483647.5,2147483647.5]", Fractions::kBounded), "");
  EXPECT_EQ(Problem("[1e30]", Fractions::kBounded), "the number 1e+30 is too large");
  EXPECT_EQ(Problem("[-2147483648.0]", Fractions::kBounded),
            "the number -2147483648.0 is too large");
}

TEST(JsonTextTest, DeeplyNestedNumbersAreChecked) {
  const std::string deep = std::string(100'000, '[') + "1e30" + std::string(100'000, ']');
  EXPECT_EQ(Problem(deep, Fractions::kBounded), "the number 1e+30 is too large");
}

TEST(JsonTextTest, WhatIsNoJsonIsAParseError) {
  EXPECT_THROW(ParseJson<Json>("{\"a\":"), Json::parse_error);
  EXPECT_TRUE(TryParseJson<Json>("{\"a\":").is_discarded());
}

}  // namespace
}  // namespace openr_host
