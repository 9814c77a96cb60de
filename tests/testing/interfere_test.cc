// Injecting, reordering, holding, losing, refusing and delaying messages.
#include "tests/testing/doubler.h"

namespace openr::testing {
namespace {

class InterfereTest : public DoublerTest {
 protected:
  InterfereTest() {
    BuildAndBoot();
    bench().RunFor(1ms);
  }
};

TEST_F(InterfereTest, AnInjectedNotifyArrivesWhetherTheObserverIsReadyOrNot) {
  EXPECT_TRUE(bench().Inject(Notify("Test1.In", "Doubler.In"), 4));
  EXPECT_TRUE(bench().Inject(Notify("Test1.In", "Doubler.In"), 5));
  bench().RunFor(1ms);
  EXPECT_EQ(out->values<int>(), (Ints{8, 10}));
}

TEST_F(InterfereTest, AnInjectedReadyIsBelieved) {
  out->set_auto_ready(false);
  in->Send(1);
  bench().RunFor(1ms);
  in->Send(2);
  bench().RunFor(1ms);
  EXPECT_EQ(out->values<int>(), Ints{2});  // `out` has not said ready since
  EXPECT_TRUE(bench().Inject(Ready("Test2.Out", "Doubler.Out")));
  bench().RunFor(1ms);
  EXPECT_EQ(out->values<int>(), (Ints{2, 4}));
}

TEST_F(InterfereTest, AnInjectedNotReadyHoldsDataBack) {
  EXPECT_TRUE(bench().Inject(NotReady("Test2.Out", "Doubler.Out")));
  bench().RunFor(1ms);
  in->Send(1);
  bench().RunFor(1ms);
  EXPECT_EQ(out->count(), 0u);
}

TEST_F(InterfereTest, AnInjectedEntryCarriesBytes) {
  EXPECT_TRUE(bench().Inject(ToEntry("Doubler", "Alarm").From("Test1"), 7));
  bench().Expect(ToEntry("Doubler", "Alarm").From("Test1"));
  bench().RunFor(1ms);
  EXPECT_EQ(doubler->alarms, Ints{7});
}

TEST_F(InterfereTest, InjectingRefusesWhatThereIsNot) {
  EXPECT_NONFATAL_FAILURE(bench().Inject(ToEntry("Doubler", "Alarms")),
                          "Inject: Doubler has no entry 'Alarms'");
  EXPECT_NONFATAL_FAILURE(bench().Inject(Notify("Test1.In", "Doubler.Out"), 4),
                          "Inject: 'Doubler.Out' is no observer of an object");
  EXPECT_THROW(bench().Inject(ToEntry("Dubler", "Alarm")), std::invalid_argument);
}

TEST_F(InterfereTest, WhatIsHeldArrivesWhenItIsReleased) {
  HeldMessages& held = bench().Hold("Test1.In", "Doubler.In");
  in->Send(1);
  bench().RunFor(5ms);
  EXPECT_EQ(held.count(), 1u);
  EXPECT_EQ(out->count(), 0u);
  EXPECT_THAT(bench().Story(),
              ::testing::HasSubstr("Behind doors of the test:\n  1 held: notify Test1.In -> "
                                   "Doubler.In\n"));
  held.Release();
  bench().RunFor(1ms);
  EXPECT_EQ(out->values<int>(), Ints{2});
  EXPECT_EQ(out->events()[0].time_us, 6000);
  in->Send(2);  // the door is open
  bench().RunFor(1ms);
  EXPECT_EQ(out->values<int>(), (Ints{2, 4}));
}

TEST_F(InterfereTest, ADoorMayLetOneThrough) {
  HeldMessages& held = bench().Hold(Notify("Test1.In", "Doubler.In"));
  for (const int number : {1, 2, 3}) bench().Inject(Notify("Test1.In", "Doubler.In"), number);
  bench().RunFor(1ms);
  EXPECT_EQ(held.count(), 3u);
  held.ReleaseOne();
  bench().RunFor(1ms);
  EXPECT_EQ(out->values<int>(), Ints{2});
  EXPECT_EQ(held.count(), 2u);
}

TEST_F(InterfereTest, WhatIsHeldMayComeInAnyOrder) {
  HeldMessages& held = bench().Hold(Notify("Test1.In", "Doubler.In"));
  for (const int number : {1, 2, 3}) bench().Inject(Notify("Test1.In", "Doubler.In"), number);
  bench().RunFor(1ms);
  EXPECT_THROW(held.ReleaseInOrder({0, 1, 1}), std::invalid_argument);
  held.ReleaseInOrder({2, 0, 1});
  for (const int number : {3, 1, 2}) bench().Expect("Test1.In", "", Data<int>(number));
  bench().RunFor(1ms);
}

TEST_F(InterfereTest, WhatIsDroppedNeverArrives) {
  DroppedMessages& dropped = bench().Drop(Notify("Doubler.Out", "Test2.Out"));
  in->Send(1);
  bench().RunFor(1ms);
  EXPECT_EQ(dropped.count(), 1);
  EXPECT_THAT(dropped.texts()[0], ::testing::HasSubstr("Doubler.Out -> Test2.Out notify, 4 bytes"));
  EXPECT_EQ(out->count(), 0u);
  // The lost ready: both sides are silent from now on, as field engineers know it.
  in->Send(2);
  bench().RunFor(1ms);
  EXPECT_EQ(out->count(), 0u);
  EXPECT_THAT(bench().Story(), ::testing::HasSubstr("Doubler waits for ready"));
}

TEST_F(InterfereTest, ARepeatedNotifyArrivesTwice) {
  const RepeatedMessage& repeated = bench().Repeat(Notify("Test1.In", "Doubler.In"), 2);
  for (const int number : {1, 2, 3}) {
    in->Send(number);
    bench().RunFor(1ms);
  }
  EXPECT_EQ(out->values<int>(), (Ints{2, 4, 4, 6}));
  EXPECT_THAT(repeated.text(), ::testing::HasSubstr("Test1.In -> Doubler.In notify, 4 bytes"));
}

// Ready is a flag and no count, so a ready that comes twice asks for one datum only.
TEST_F(InterfereTest, ARepeatedReadyAsksForOneDatumOnly) {
  out->set_auto_ready(false);
  const RepeatedMessage& repeated = bench().Repeat(Ready("Test2.Out", "Doubler.Out"));
  out->AssertReady();
  for (const int number : {1, 2}) {
    bench().RunFor(1ms);
    in->Send(number);
  }
  bench().RunFor(1ms);
  EXPECT_TRUE(repeated.happened());
  EXPECT_EQ(out->values<int>(), Ints{2});
}

TEST_F(InterfereTest, ARepeatedEntryCarriesItsBytes) {
  bench().Repeat(ToEntry("Doubler", "Alarm"));
  bench().Inject(ToEntry("Doubler", "Alarm").From("Test1"), 7);
  bench().RunFor(1ms);
  EXPECT_EQ(doubler->alarms, (Ints{7, 7}));
}

TEST_F(InterfereTest, ARepeatThatCannotPostItsMessageSaysSo) {
  bench().Repeat(ToEntry("Doubler", "Alarm"));
  bench().Refuse(ToEntry("Doubler", "Alarm"), 2);
  bench().Inject(ToEntry("Doubler", "Alarm").From("Test1"), 7);
  EXPECT_NONFATAL_FAILURE(bench().RunFor(1ms), "Repeat: the queue of the receiver is full");
}

TEST_F(InterfereTest, ARepeatWhoseMessageNeverComesFails) {
  bench().Repeat(Notify("Test1.In", "Doubler.In"), 2);
  in->Send(1);
  bench().RunFor(1ms);
  EXPECT_NONFATAL_FAILURE(bench().Verify(), "Repeat: 1 of 2 came: notify Test1.In -> Doubler.In");
}

TEST_F(InterfereTest, ADroppedReadyStopsTheConnection) {
  bench().Drop(Ready("Doubler.In", "Test1.In"));
  for (int i = 1; i <= 3; ++i) {
    in->Send(i);
    bench().RunFor(1ms);
  }
  EXPECT_EQ(out->values<int>(), Ints{2});
}

TEST_F(InterfereTest, TheSenderOfARefusedMessageKeepsItsData) {
  RefusedMessage& refused = bench().Refuse(Notify("Test1.In", "Doubler.In"));
  in->Send(1);
  bench().RunFor(1ms);
  EXPECT_TRUE(refused.happened());
  EXPECT_THAT(refused.text(), ::testing::HasSubstr("Test1.In -> Doubler.In notify"));
  EXPECT_EQ(out->count(), 0u);
  EXPECT_THAT(bench().Findings(), ::testing::HasSubstr("refuses a message, as a full queue does"));
  bench().Expect("Test1.In", "Doubler.In", DataAre<int>(::testing::ElementsAre(1, 2)));
  in->Send(2);  // the one that was refused goes with it
  bench().RunFor(1ms);
}

TEST_F(InterfereTest, TheNthSendIsTheOneThatFails) {
  RefusedMessage& refused = bench().Refuse(Notify("Test1.In"), 3);
  for (int i = 1; i <= 4; ++i) {
    in->Send(i);
    bench().RunFor(1ms);
    EXPECT_EQ(refused.happened(), i >= 3) << i;
  }
  EXPECT_EQ(out->values<int>(), (Ints{2, 4, 6, 8}));  // 3 went with 4
}

// If fewer messages come than the test wants to drop or refuse, the test or a name in it is wrong.
TEST_F(InterfereTest, WhatNeverComesAlongIsAFailureAtTheEnd) {
  bench().Drop(Notify("Test1.In"), 2);
  in->Send(1);
  bench().RunFor(1ms);
  EXPECT_NONFATAL_FAILURE(bench().Verify(),
                          "Drop: 1 of 2 came: notify Test1.In -> (any); .Optional() allows that");
  bench().Refuse(Notify("Doubler.Out"), 3);
  EXPECT_NONFATAL_FAILURE(
      EndBench(), "Refuse: 0 of 3 came: notify Doubler.Out -> (any); .Optional() allows that");
}

TEST_F(InterfereTest, ADoorThatNobodyCameToIsAFailureAtTheEnd) {
  bench().Hold("Test1.In", "Doubler.In");
  EXPECT_NONFATAL_FAILURE(EndBench(), "Hold: nothing ever came: notify Test1.In -> Doubler.In");
}

TEST_F(InterfereTest, WhatNeedNotComeAlongIsAskedForSo) {
  bench().Drop(Notify("Test1.In"), 2).Optional();
  bench().Hold(Ready("Doubler.In")).Optional();
  EXPECT_FALSE(bench().Refuse(Notify("Doubler.Out")).Optional().happened());
  EndBench();
}

TEST_F(InterfereTest, ADelayedConnectionIsSlowAndStaysInOrder) {
  bench().Delay(Notify("Test1.In"), 3ms);
  bench().Inject(Notify("Test1.In", "Doubler.In"), 1);
  bench().Delay(Notify("Test1.In"), 0ms);
  bench().Inject(Notify("Test1.In", "Doubler.In"), 2);  // does not overtake
  bench().RunFor(2ms);
  EXPECT_EQ(out->count(), 0u);
  bench().RunFor(2ms);
  EXPECT_EQ(out->values<int>(), (Ints{2, 4}));
  EXPECT_EQ(out->events()[0].time_us, 4000);
}

// A wrong name is one mistake: that no message fits it must not be a second failure.
class WrongNameTest : public DoublerTest, public ::testing::WithParamInterface<bool> {
 protected:
  // Calls `use` before the boot or after it, and ends the bench.
  void UseAndEnd(const std::function<void()>& use) {
    Build();
    if (GetParam()) use();
    bench().Boot();
    if (!GetParam()) use();
    bench().RunFor(1ms);
    EndBench();
  }
};
INSTANTIATE_TEST_SUITE_P(BeforeAndAfterBoot, WrongNameTest, ::testing::Bool());

TEST_P(WrongNameTest, OfAHoldFailsOnce) {
  EXPECT_NONFATAL_FAILURE(UseAndEnd([this] { bench().Hold(Notify("", "Dubler")); }),
                          "There is no object 'Dubler' on this bench");
}

TEST_P(WrongNameTest, OfADropFailsOnce) {
  EXPECT_NONFATAL_FAILURE(UseAndEnd([this] { bench().Drop(Notify("Dubler.Out")); }),
                          "There is no service 'Dubler.Out' on this bench");
}

TEST_P(WrongNameTest, OfARepeatFailsOnce) {
  EXPECT_NONFATAL_FAILURE(UseAndEnd([this] { bench().Repeat(Notify("Dubler")); }),
                          "There is no object 'Dubler' on this bench");
}

TEST_P(WrongNameTest, OfARefuseFailsOnce) {
  EXPECT_NONFATAL_FAILURE(UseAndEnd([this] { bench().Refuse(Notify("Dubler")); }),
                          "There is no object 'Dubler' on this bench");
}

// Three observers of one subject: whose handler is next is left open.
class OrderTest : public ::testing::Test {
 protected:
  Texts Run(BenchOptions options, const std::vector<std::string>& order) {
    Bench bench(std::move(options));
    Texts calls;
    Probe& source = bench.AddProbe("Source", {"Source.Out.int.S"});
    for (const std::string name : {"A", "B", "C"}) {
      Probe& probe = bench.AddProbe(name, {name + ".In.int.O"});
      probe.set_on_start([&calls, name] { calls.push_back("start " + name); });
      probe.observer("In").set_on_event(
          [&calls, name](const ONotifyEvent&) { calls.push_back(name); });
      bench.Wire("Source.Out.int.S", name + ".In.int.O");
    }
    bench.Reorder(order);
    bench.Boot();
    bench.RunFor(1ms);
    source.subject("Out").Send(1);
    bench.RunFor(1ms);
    return calls;
  }
};

TEST_F(OrderTest, ReorderChoosesWhereTheRobotLeavesTheOrderOpen) {
  EXPECT_EQ(Run({.seed = 1}, {}), (Texts{"start A", "start B", "start C", "A", "B", "C"}));
  EXPECT_EQ(Run({.seed = 1}, {"C", "B"}), (Texts{"start C", "start B", "start A", "C", "B", "A"}));
}

TEST_F(OrderTest, ASeedChoosesToo) {
  const Texts canonical = Run({.seed = 1}, {});
  int others = 0;
  for (uint64_t seed = 2; seed < 12; ++seed) {
    const Texts calls = Run({.seed = seed}, {});
    EXPECT_EQ(calls, Run({.seed = seed}, {}));
    others += calls != canonical ? 1 : 0;
  }
  EXPECT_GT(others, 0);
}

}  // namespace
}  // namespace openr::testing
