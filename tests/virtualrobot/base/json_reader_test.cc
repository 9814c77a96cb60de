#include "virtualrobot/base/json_reader.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/virtualrobot/body_harness.h"

namespace openr_host {
namespace {

using Read = std::function<void(const JsonReader&)>;

// Returns the error of reading the member "a" of a file with this text; "" if it is good.
std::string ErrorIn(const std::string& text, const Read& read) {
  const nlohmann::json json = JsonReader::ParseText(text, "f.json");
  try {
    read(JsonReader(json, "f.json").At("a"));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(JsonReaderTest, AnErrorOfSyntaxNamesLineAndColumn) {
  EXPECT_EQ(ErrorOf([] { JsonReader::ParseText("{\n  \"a\": 1,\n  oops\n}", "f.json"); }),
            "f.json:3:3: not valid JSON here");
  EXPECT_EQ(ErrorOf([] { JsonReader::ParseText("]", "f.json"); }),
            "f.json:1:1: not valid JSON here");
}

TEST(JsonReaderTest, ANumberThatIsTooLargeIsNamedWithItsPlace) {
  EXPECT_EQ(
      ErrorOf([] { JsonReader::ParseText("{\"1e999\": 1,\n  \"a\": [2, -1e999]}", "f.json"); }),
      "f.json:2:12: the number -1e999 is too large");
  EXPECT_EQ(ErrorOf([] { JsonReader::ParseText("[\"a\\\"\", 5, 1e400]", "f.json"); }),
            "f.json:1:12: the number 1e400 is too large");
}

TEST(JsonReaderTest, MembersAreFoundInObjectsOnly) {
  const nlohmann::json json = nlohmann::json::parse(R"({"a": {"b": [1, {"c": true}]}})");
  const JsonReader root(json, "f.json");
  EXPECT_TRUE(root.Has("a"));
  EXPECT_FALSE(root.Has("b"));
  EXPECT_FALSE(root.At("a").At("b").Has("c"));
  EXPECT_TRUE(root.At("a").At("b").Elements()[1].At("c").Bool());
  EXPECT_EQ(ErrorOf([&] { root.At("b"); }), "f.json: 'b' is missing");
  EXPECT_EQ(ErrorOf([&] { root.At("a").At("b").At("c"); }),
            "f.json: a.b: must be an object with 'c'");
  EXPECT_EQ(ErrorOf([&] { root.At("a").At("b").Elements()[1].At("d"); }),
            "f.json: a.b[1]: 'd' is missing");
}

TEST(JsonReaderTest, OnlyKnownMembersAreAllowed) {
  const Read read = [](const JsonReader& reader) { reader.AllowOnly({"x", "y"}); };
  EXPECT_EQ(ErrorIn(R"({"a": {"x": 1, "y": 2}})", read), "");
  EXPECT_EQ(ErrorIn(R"({"a": {}})", read), "");
  EXPECT_EQ(ErrorIn(R"({"a": {"z": 1}})", read), "f.json: a: 'z' is unknown; known here: x, y");
  EXPECT_EQ(ErrorIn(R"({"a": []})", read), "f.json: a: must be an object, is []");
  EXPECT_EQ(ErrorIn(R"({"a": 5})", read), "f.json: a: must be an object, is 5");
}

TEST(JsonReaderTest, AValueOfAnotherKindIsShown) {
  EXPECT_EQ(ErrorIn(R"({"a": 5})", [](const JsonReader& reader) { reader.Text(); }),
            "f.json: a: must be a text, is 5");
  EXPECT_EQ(ErrorIn(R"({"a": 1})", [](const JsonReader& reader) { reader.Bool(); }),
            "f.json: a: must be true or false, is 1");
  EXPECT_EQ(ErrorIn(R"({"a": true})", [](const JsonReader& reader) { reader.Number(); }),
            "f.json: a: must be a number, is true");
  EXPECT_EQ(ErrorIn(R"({"a": 1.5})", [](const JsonReader& reader) { reader.Whole(0, 9); }),
            "f.json: a: must be a whole number, is 1.5");
  EXPECT_EQ(ErrorIn(R"({"a": {}})", [](const JsonReader& reader) { reader.Elements(); }),
            "f.json: a: must be a list, is {}");
}

TEST(JsonReaderTest, AMemberThatMayBeMissingHasAValueOfItsOwnThen) {
  const nlohmann::json json = nlohmann::json::parse(R"({"t": "x", "b": true, "w": 3})");
  const JsonReader root(json, "f.json");
  EXPECT_EQ(root.TextOr("t", "y"), "x");
  EXPECT_EQ(root.TextOr("none", "y"), "y");
  EXPECT_TRUE(root.BoolOr("b", false));
  EXPECT_FALSE(root.BoolOr("none", false));
  EXPECT_EQ(root.WholeOr("w", 0, 9, 5), 3);
  EXPECT_EQ(root.WholeOr("none", 0, 9, 5), 5);
  EXPECT_EQ(ErrorOf([&] { root.WholeOr("w", 0, 2, 1); }), "f.json: w: is 3, must be 0 to 2");
  EXPECT_EQ(ErrorOf([&] { root.TextOr("w", ""); }), "f.json: w: must be a text, is 3");
}

TEST(JsonReaderTest, LimitsBelongToTheRangeAndAFloorDoesNot) {
  const auto whole = [](const char* value) {
    return ErrorIn(fmt::format(R"({{"a": {}}})", value),
                   [](const JsonReader& reader) { reader.Whole(2, 4); });
  };
  EXPECT_EQ(whole("1"), "f.json: a: is 1, must be 2 to 4");
  EXPECT_EQ(whole("2"), "");
  EXPECT_EQ(whole("4"), "");
  EXPECT_EQ(whole("5"), "f.json: a: is 5, must be 2 to 4");
  const auto within = [](const char* value) {
    return ErrorIn(fmt::format(R"({{"a": {}}})", value),
                   [](const JsonReader& reader) { reader.NumberWithin(0.5, 1); });
  };
  EXPECT_EQ(within("0.4"), "f.json: a: is 0.4, must be 0.5 to 1");
  EXPECT_EQ(within("0.5"), "");
  EXPECT_EQ(within("1"), "");
  EXPECT_EQ(within("1.1"), "f.json: a: is 1.1, must be 0.5 to 1");
  const auto above = [](const char* value) {
    return ErrorIn(fmt::format(R"({{"a": {}}})", value),
                   [](const JsonReader& reader) { reader.NumberAbove(0.5); });
  };
  EXPECT_EQ(above("0.5"), "f.json: a: is 0.5, must be > 0.5");
  EXPECT_EQ(above("0.6"), "");
}

TEST(JsonReaderTest, DeeplyNestedJsonIsRefused) {
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  EXPECT_EQ(ErrorOf([&] { JsonReader::ParseText(deep, "f.json"); }),
            "f.json: is nested more than 100 levels deep");
}

TEST(JsonReaderTest, AListOfNumbersHasItsLength) {
  const nlohmann::json json = nlohmann::json::parse(R"({"a": [1, 2, 3]})");
  const JsonReader list = JsonReader(json, "f.json").At("a");
  EXPECT_EQ(list.Numbers(3), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(list.Vector(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(ErrorOf([&] { list.Numbers(2); }), "f.json: a: must have 2 numbers, has 3");
  EXPECT_EQ(ErrorIn(R"({"a": [1, "x"]})", [](const JsonReader& reader) { reader.Numbers(2); }),
            "f.json: a[1]: must be a number, is \"x\"");
}

}  // namespace
}  // namespace openr_host
