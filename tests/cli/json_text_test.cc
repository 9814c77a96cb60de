#include "cli/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

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

std::string Nested(size_t depth, const std::string& inside) {
  return std::string(depth, '[') + inside + std::string(depth, ']');
}

TEST(JsonTextTest, NestedNumbersAreChecked) {
  EXPECT_EQ(Problem(Nested(100, "1e30"), Fractions::kBounded), "the number 1e+30 is too large");
}

// The JSON library would overflow the stack when it copies or writes such JSON.
TEST(JsonTextTest, DeeplyNestedJsonIsRefused) {
  EXPECT_EQ(JsonText(ParseJson<Json>(Nested(100, ""))), Nested(100, ""));
  for (const size_t depth : {size_t{101}, size_t{1'000'000}}) {
    EXPECT_EQ(Problem(Nested(depth, ""), Fractions::kBounded),
              "the JSON is nested more than 100 levels deep");
    EXPECT_TRUE(TryParseJson<Json>(Nested(depth, "")).is_discarded());
  }
  std::string objects;
  for (int i = 0; i < 101; ++i) objects += "{\"a\":";
  EXPECT_THROW(ParseJson<Json>(objects), JsonTooDeep);
}

TEST(JsonTextTest, CharactersThatATerminalObeysAreEscaped) {
  const Json json = "\x1b a\x7f\xc2\x9b\xc2\xb0\xc3\xa9";
  const std::string text = JsonText(json);
  EXPECT_EQ(text, "\"\\u001b a\\u007f\\u009b\xc2\xb0\xc3\xa9\"");
  EXPECT_EQ(ParseJson<Json>(text), json);
}

TEST(JsonTextTest, BracketsInTextsAreNotNested) {
  const std::string brackets(1000, '[');
  for (const std::string& text : {"\"" + brackets + "\"", "[\"\\\"" + brackets + "\",\"\\\\\"]"})
    EXPECT_EQ(JsonText(ParseJson<Json>(text)), text);
  std::string list = "[0";
  for (int i = 0; i < 1000; ++i) list += ",[{}]";
  EXPECT_EQ(ParseJson<Json>(list + "]").size(), 1001u);
}

TEST(JsonTextTest, ListsAreLeftOut) {
  const std::string deep = Nested(1'000'000, "{\"id\":1}");
  const Json json = ParseWithoutLists("{\"a\":" + deep + ",\"b\":{\"c\":[1],\"d\":2},\"e\":[]}");
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json.at("b").at("d"), 2);
  for (const char* const name : {"a", "e"}) EXPECT_FALSE(json.value(name, Json()).is_array());
  for (const std::string& text : {deep, std::string("{\"a\":"), std::string()})
    EXPECT_FALSE(ParseWithoutLists(text).is_object());
}

TEST(JsonTextTest, APlainMemberIsFoundBesideNestedOnes) {
  const std::string deep = Nested(1'000'000, "{\"id\":1}");
  for (const char* const id : {"7", "-7", "0.5", "\"a\"", "true"}) {
    EXPECT_EQ(JsonText(PlainMember("{\"a\":" + deep + ",\"id\":" + id + "}", "id")), id);
    EXPECT_EQ(JsonText(PlainMember("{\"id\":" + std::string(id) + ",\"a\":" + deep + "}", "id")),
              id);
  }
  EXPECT_EQ(PlainMember("{\"b\":{\"id\":1},\"c\":[2,{\"id\":3}],\"id\":4,\"d\":{}}", "id"), 4);
}

TEST(JsonTextTest, NestedAndMissingMembersAreNull) {
  const std::string deep = Nested(1'000'000, "");
  const std::vector<std::string> texts = {"{\"id\":" + deep + "}",
                                          "{\"id\":{\"id\":1},\"a\":2}",
                                          "[" + deep + ",{\"id\":1}]",
                                          "{\"a\":{\"id\":1}}",
                                          "{\"id\":1,\"a\":" + deep,
                                          "{\"id\":null}",
                                          "{\"id\":1e999}",
                                          "7",
                                          ""};
  for (const std::string& text : texts)
    EXPECT_TRUE(PlainMember(text, "id").is_null()) << text.substr(0, 40);
}

TEST(JsonTextTest, WhatIsNoJsonIsAParseError) {
  EXPECT_THROW(ParseJson<Json>("{\"a\":"), Json::parse_error);
  EXPECT_TRUE(TryParseJson<Json>("{\"a\":").is_discarded());
}

}  // namespace
}  // namespace openr_host
