#include "runtime/base/duration.h"

#include <gtest/gtest.h>

namespace openr_host {
namespace {

int64_t Parsed(const char* text) {
  int64_t us = -1;
  EXPECT_EQ(ParseDuration(text, &us), "") << text;
  return us;
}

std::string Refusal(const char* text) {
  int64_t us = -7;
  const std::string problem = ParseDuration(text, &us);
  EXPECT_EQ(us, -7) << "a refused duration must not change anything";
  return problem;
}

TEST(DurationTest, EveryUnitIsRead) {
  EXPECT_EQ(Parsed("5us"), 5);
  EXPECT_EQ(Parsed("250ms"), 250'000);
  EXPECT_EQ(Parsed("20s"), 20'000'000);
  EXPECT_EQ(Parsed("2min"), 120'000'000);
  EXPECT_EQ(Parsed("1h"), 3'600'000'000);
  EXPECT_EQ(Parsed("0s"), 0);
}

TEST(DurationTest, FractionsAreExactToTheMicrosecond) {
  EXPECT_EQ(Parsed("1.5s"), 1'500'000);
  EXPECT_EQ(Parsed("0.1ms"), 100);
  EXPECT_EQ(Parsed("0.000001s"), 1);
}

TEST(DurationTest, ANumberWithoutUnitIsRefusedWithARemedy) {
  EXPECT_EQ(Refusal("20"), "'20' has no unit; write 20s or 20ms");
}

TEST(DurationTest, AnUnknownUnitIsNamed) {
  EXPECT_EQ(Refusal("3days"), "'3days' has the unknown unit 'days'; units are us, ms, s, min, h");
}

TEST(DurationTest, NonsenseIsRefused) {
  for (const char* text : {"", "s", "abc", "nan s", "infs", "--5s", " 5s"}) {
    EXPECT_NE(Refusal(text), "") << text;
  }
}

TEST(DurationTest, NegativeAndEndlessOnesAreRefused) {
  EXPECT_EQ(Refusal("-1s"), "'-1s' is out of range; durations go from 0 to 1000h");
  EXPECT_EQ(Refusal("1001h"), "'1001h' is out of range; durations go from 0 to 1000h");
}

TEST(DurationTest, FormattingUsesTheBiggestUnitThatFits) {
  EXPECT_EQ(FormatDuration(250'000), "250ms");
  EXPECT_EQ(FormatDuration(120'000'000), "120s");
  EXPECT_EQ(FormatDuration(6'000'000'000), "6000s");
  EXPECT_EQ(FormatDuration(1'500'000), "1500ms");
  EXPECT_EQ(FormatDuration(0), "0s");
}

}  // namespace
}  // namespace openr_host
