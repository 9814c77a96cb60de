// Tests of messages that are expected, allowed or disallowed, and of the texts of failures.
#include "tests/testing/doubler.h"

namespace openr::testing {
namespace {

using ::testing::_;
using ::testing::ElementsAre;
using ::testing::Gt;

class ExpectationsTest : public DoublerTest {
 protected:
  ExpectationsTest() {
    BuildAndBoot();
    bench().RunFor(1ms);
  }
  // Sends the numbers, 1 ms apart.
  void Send(const Ints& numbers) {
    for (const int number : numbers) {
      in->Send(number);
      bench().RunFor(1ms);
    }
  }
};

TEST_F(ExpectationsTest, WhatHappensInOrderIsMet) {
  bench().Expect("Test1.In", "Doubler.In", Data<int>(1));
  bench().Expect("Doubler.Out", "Test2.Out", Data<int>(2));
  bench().Expect(Ready("Doubler.In", "Test1.In"));
  bench().Expect("Doubler.Out", "Test2.Out", Data<int>(Gt(3)));
  Send({1, 2});
  bench().Verify();
}

TEST_F(ExpectationsTest, WhatDoesNotHappenFailsWithTheNearestThatDid) {
  bench().Expect("Doubler.Out", "Test2.Out", Data<int>(6));
  bench().Expect("Doubler.Out", "Test2.Out", Data<int>(8));
  Send({1});
  EXPECT_NONFATAL_FAILURE(
      bench().Verify(),
      "Expected, but it did not happen: notify Doubler.Out -> Test2.Out with a datum that is equal "
      "to 6\n  this did, with another payload: #");
  bench().Expect("Doubler.Out", "Test2.Out", Data<int>(6));
  bench().Expect("Doubler.Out", "Test2.Out", Data<int>(8));
  Send({1});
  EXPECT_NONFATAL_FAILURE(
      bench().Verify(),
      "\n    whose datum is 2\n"
      "and after it: notify Doubler.Out -> Test2.Out with a datum that is equal "
      "to 8\nt=0.003000 s.  Last messages:\n");
}

TEST_F(ExpectationsTest, TheOrderMatters) {
  bench().Expect("Doubler.Out", "", Data<int>(4));
  bench().Expect("Doubler.Out", "", Data<int>(2));
  Send({1, 2});
  EXPECT_NONFATAL_FAILURE(
      bench().Verify(),
      "Expected, but it did not happen: notify Doubler.Out -> (any) with a datum that is equal to 2"
      "\n  this did, before its turn: #");
}

TEST_F(ExpectationsTest, WhatCameTooEarlyIsNamed) {
  bench().Expect("Doubler.Out", "", Data<int>(4));
  bench().Expect(NotReady());
  bench().Expect("Doubler.Out", "", Data<int>(4));
  Send({2, 2});
  EXPECT_NONFATAL_FAILURE(bench().Verify(),
                          "Expected, but it did not happen: not ready\nand after it: notify "
                          "Doubler.Out -> (any) with a datum that is equal to 4");
}

TEST_F(ExpectationsTest, TheEndOfTheBenchVerifies) {
  bench().Expect(NotReady());
  EXPECT_NONFATAL_FAILURE(EndBench(), "Expected, but it did not happen: not ready");
}

TEST_F(ExpectationsTest, RunUntilMetEndsWithTheLastOne) {
  bench().Expect("Doubler.Out", "Test2.Out");
  in->Send(1);
  EXPECT_TRUE(bench().RunUntilMet(1s));
  EXPECT_EQ(bench().now_us(), 1000);
  bench().Expect("Doubler.Out", "Test2.Out");
  EXPECT_NONFATAL_FAILURE(bench().RunUntilMet(2s),
                          "Expected, but it did not happen: notify Doubler.Out -> Test2.Out\n"
                          "within 2 s\n");
}

TEST_F(ExpectationsTest, WhatIsDisallowedFailsWhenItHappens) {
  bench().Disallow("Doubler.Out", "Test2.Out", Data<int>(Gt(10)));
  Send({1, 2});
  in->Send(6);
  EXPECT_NONFATAL_FAILURE(
      bench().RunFor(1ms),
      "Disallowed, but it happened: notify Doubler.Out -> Test2.Out with a datum "
      "that is > 10\n  #");
  Send({7});  // reported once
}

TEST_F(ExpectationsTest, ABenchIsNiceUnlessItIsStrict) {
  Send({1});
  bench().set_strict(true);
  in->Send(2);
  bench().Allow("Test1.In", "Doubler.In");
  EXPECT_NONFATAL_FAILURE(bench().RunFor(1ms), "Not expected, and the bench is strict:\n  #");
  bench().Expect("Doubler.Out", "Test2.Out", Data<int>(8));
  in->Send(3);
  EXPECT_NONFATAL_FAILURE(bench().RunFor(1ms),
                          "\nExpected next: notify Doubler.Out -> Test2.Out with a datum that is "
                          "equal to 8\n");
  Send({4});
  bench().set_strict(false);
  Send({5});
}

TEST_F(ExpectationsTest, StrictnessIsAboutNotificationsOnly) {
  bench().set_strict(true);
  bench().Allow("Test1.In", "");
  bench().Expect("Doubler.Out", "");
  Send({1});  // readies go as well
}

TEST_F(ExpectationsTest, PayloadsOfSeveralData) {
  out->set_auto_ready(false);
  bench().Expect("Test1.In", "", DataAre<int>(ElementsAre(1, 2)));
  in->Set(1);
  in->Set(2);
  in->Notify();
  bench().RunFor(1ms);
  bench().Verify();
  bench().Expect("Test1.In", "", Data<int>(_));
  in->Set(1);
  in->Set(2);
  in->Notify();
  bench().RunFor(1ms);
  EXPECT_NONFATAL_FAILURE(bench().Verify(), "which has 2 data");
}

TEST_F(ExpectationsTest, APayloadOfAnotherSizeDoesNotMatchAndSaysSo) {
  bench().Expect("Test1.In", "", Data<double>(_));
  Send({1});
  EXPECT_NONFATAL_FAILURE(bench().Verify(), "whose datum 0 has 4 bytes, where the type has 8");
}

TEST(TextTest, TextsAreComparedAsTexts) {
  Bench bench;
  bench.AddProbe("A", {"A.Say.Text.S"});
  bench.AddProbe("B", {"B.Hear.Text.O"});
  bench.Wire("A.Say.Text.S", "B.Hear.Text.O");
  bench.Boot();
  bench.RunFor(1ms);
  bench.Expect("A.Say", "B.Hear", Text("hello"));
  bench.Expect("A.Say", "B.Hear", Text(::testing::StartsWith("good")));
  bench.probe("A").subject("Say").SendText("hello");
  bench.RunFor(1ms);
  bench.probe("A").subject("Say").SendText("bye");
  bench.RunFor(1ms);
  EXPECT_EQ(bench.probe("B").observer("Hear").events().back().text(), "bye");
  EXPECT_NONFATAL_FAILURE(bench.Verify(),
                          "notify A.Say -> B.Hear with a text that starts with \"good\"\n");
}

}  // namespace
}  // namespace openr::testing
