// Property files: what they say, and their complaints.
#include "openr/explore/property_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace openr_host {
namespace {

std::string ErrorIn(const std::string& text) {
  std::vector<Diagnostic> diagnostics;
  ParseProperties("my.prop", text, &diagnostics);
  return diagnostics.empty() ? "" : Render(diagnostics[0]);
}

TEST(PropertyFileTest, ALineHasNameTimeAndComparison) {
  std::vector<Diagnostic> diagnostics;
  const auto rules =
      ParseProperties("my.prop",
                      "# comment\n"
                      "stands: eventually from 1s within 20s robots[0].standing == true\n"
                      "always objects.B.state != gave up \n",
                      &diagnostics);
  EXPECT_TRUE(diagnostics.empty());
  ASSERT_EQ(rules.size(), 2u);
  EXPECT_EQ(rules[0].name, "stands");
  EXPECT_EQ(rules[0].when, PropertyRule::When::kEventually);
  EXPECT_EQ(rules[0].from_us, 1'000'000);
  EXPECT_EQ(rules[0].within_us, 20'000'000);
  EXPECT_EQ(rules[1].name, "line 3");
  EXPECT_EQ(rules[1].value, "gave up");
}

TEST(PropertyFileTest, WrongLinesAreShown) {
  EXPECT_EQ(ErrorIn("sometimes messages > 1\n"),
            "my.prop:1: 'sometimes' is neither always nor eventually nor finally\n"
            "sometimes messages > 1\n^");
  EXPECT_EQ(ErrorIn("x: alway messages > 1\n"),
            "my.prop:1: 'alway' is neither always nor eventually nor finally; did you mean "
            "'always'?\n"
            "x: alway messages > 1\n"
            "   ^");
  EXPECT_EQ(ErrorIn("always messages = 1\n"),
            "my.prop:1: '=' compares nothing; there are == != < <= > >=\n"
            "always messages = 1\n"
            "                ^");
  EXPECT_EQ(ErrorIn("always within 1s messages > 1\n"),
            "my.prop:1: only 'eventually' has a 'within'\n"
            "always within 1s messages > 1\n"
            "       ^");
  EXPECT_EQ(ErrorIn("always messages\n"),
            "my.prop:1: write: QUANTITY OP VALUE, such as objects.JointMover.state == failed\n"
            "always messages\n"
            "       ^");
}

TEST(PropertyFileTest, NumbersAreComparedAsNumbersAndTextsForEquality) {
  EXPECT_TRUE(Compares(10.0, ">", "9"));
  EXPECT_TRUE(Compares(-0.5, "<=", "-0.5"));
  EXPECT_FALSE(Compares(1.0, "!=", "1.0"));
  EXPECT_TRUE(Compares(std::string("a b"), "==", "a b"));
  EXPECT_THROW(Compares(std::string("a"), "<", "b"), std::runtime_error);
  EXPECT_THROW(Compares(1.0, "==", "one"), std::runtime_error);
}

TEST(PropertyChoiceTest, AnUnknownNameNamesTheNearest) {
  try {
    PropertyChoice{{"no-drop"}}.Make();
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "'no-drop' is neither a property nor a file of properties (docs/exploring.md); "
                 "did you mean 'no-drops'?");
  }
}

TEST(PropertyChoiceTest, DefaultIsWhatTheTableSays) {
  size_t by_default = 0;
  for (const PropertyEntry& entry : PropertyTable()) by_default += entry.by_default;
  EXPECT_EQ(PropertyChoice{}.Make().size(), by_default);
  EXPECT_EQ((PropertyChoice{{"standing", "always messages >= 0"}}.Make().size()), 2u);
}

}  // namespace
}  // namespace openr_host
