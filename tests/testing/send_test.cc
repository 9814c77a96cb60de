// The inputs `send`, `type` and `shutdown`, and when inputs take effect.
#include "runtime/core/system_inputs.h"
#include "tests/testing/doubler.h"

namespace openr::testing {
namespace {

class SendTest : public DoublerTest {
 protected:
  SendTest() {
    BuildAndBoot();
    bench().RunFor(1ms);
  }
  std::string Refusal(const char* line) { return bench().system().inputs().Check(0, line); }
};

TEST_F(SendTest, ASentValueArrivesAtTheNextFrameBoundary) {
  EXPECT_TRUE(bench().Do("send Doubler.In 4"));
  bench().RunFor(6ms);
  EXPECT_EQ(out->count(), 0u);
  bench().RunFor(1ms);
  EXPECT_EQ(out->values<int>(), Ints{8});
  EXPECT_EQ(out->events()[0].time_us, 8000);
}

TEST_F(SendTest, AnInputAtAFrameBoundaryTakesEffectAtOnce) {
  bench().Frame();
  EXPECT_EQ(bench().now_us() % 8000, 0);
  EXPECT_TRUE(bench().Do("send Doubler.In from Test1.In 5"));
  bench().RunFor(0ms);
  EXPECT_EQ(out->values<int>(), Ints{10});
}

TEST_F(SendTest, WhatCannotBeSentIsRefused) {
  EXPECT_THAT(Refusal("send"), ::testing::HasSubstr("names no observer"));
  EXPECT_THAT(Refusal("send Doubler.In"), ::testing::HasSubstr("has no value to send"));
  EXPECT_THAT(Refusal("send Doubler.Im 4"), ::testing::HasSubstr("no object has the observer"));
  EXPECT_THAT(Refusal("send Doubler.In from Nobody.In 4"),
              ::testing::HasSubstr("no object has the subject 'Nobody.In'"));
  EXPECT_THAT(Refusal("send Doubler.In word:4"), ::testing::HasSubstr("'word' is no type"));
  EXPECT_THAT(Refusal("send Doubler.In 3000000000000"), ::testing::HasSubstr("does not fit"));
  EXPECT_THAT(Refusal("send Doubler.In hex:0"), ::testing::HasSubstr("two digits for each byte"));
  EXPECT_THAT(Refusal("send Doubler.In hex:0g"), ::testing::HasSubstr("hexadecimal"));
}

TEST_F(SendTest, ValuesBecomeBytes) {
  const auto bytes = [](const char* word) {
    std::string result;
    EXPECT_EQ(openr_host::ReadMessageValue(word, &result), "") << word;
    return result;
  };
  EXPECT_EQ(bytes("5"), std::string("\5\0\0\0", 4));
  EXPECT_EQ(bytes("-1"), "\xff\xff\xff\xff");
  EXPECT_EQ(bytes("4294967295"), "\xff\xff\xff\xff");
  EXPECT_EQ(bytes("byte:255"), "\xff");
  EXPECT_EQ(bytes("short:258"), "\2\1");
  EXPECT_EQ(bytes("long:1"), std::string("\1\0\0\0\0\0\0\0", 8));
  EXPECT_EQ(bytes("hex:00ff"), std::string("\0\xff", 2));
  EXPECT_EQ(bytes("\"two words\""), "two words");
  EXPECT_EQ(bytes("1.5"), std::string("\0\0\0\0\0\0\xf8\x3f", 8));
  EXPECT_EQ(bytes("float:1.5"), std::string("\0\0\xc0\x3f", 4));
}

// Before the boot the services are not known yet, so a wrong name is found when the input is done.
TEST(SendBeforeBootTest, AWrongNameIsAnErrorFinding) {
  Bench bench;
  EXPECT_TRUE(bench.Do("send Nobody.In 4"));
  bench.ExpectFinding(::testing::HasSubstr("input: send: no object has the observer 'Nobody.In'"));
  bench.Boot();
  bench.RunFor(8ms);
}

TEST_F(SendTest, AShutdownEndsTheRunWithItsReason) {
  EXPECT_TRUE(bench().Do("shutdown"));
  bench().RunFor(8ms);
  ASSERT_TRUE(bench().system().end());
  EXPECT_THAT(bench().system().end()->why, ::testing::HasSubstr("the input 'shutdown'"));
}

TEST_F(SendTest, ListenersHearTheLinesThatAreAccepted) {
  Texts heard;
  bench().system().inputs().OnAdd([&](int robot, std::string_view line) {
    heard.push_back(std::to_string(robot) + line.data());
  });
  EXPECT_TRUE(bench().Do("send Doubler.In 1"));
  EXPECT_NE(bench().system().inputs().Add(0, "send Doubler.In x"), "");
  EXPECT_NE(bench().system().inputs().Add(1, "send Doubler.In 1"), "");
  EXPECT_EQ(heard, Texts{"0send Doubler.In 1"});
}

}  // namespace
}  // namespace openr::testing
