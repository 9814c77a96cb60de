// The verbs that let a bench run.
#include "tests/testing/doubler.h"

namespace openr::testing {
namespace {

class RunTest : public DoublerTest {
 protected:
  RunTest() { BuildAndBoot(); }
};

TEST_F(RunTest, BootEndsWithTheLastDoStart) {
  EXPECT_EQ(bench().probe("Test1").calls(), (Texts{"DoInit", "DoStart"}));
  EXPECT_TRUE(bench().system().booted());
  EXPECT_EQ(bench().now_us(), 0);
}

TEST_F(RunTest, StepDeliversOneMessage) {
  bench().RunFor(1ms);
  in->Send(21);
  EXPECT_EQ(out->count(), 0u);
  EXPECT_TRUE(bench().Step());  // the notify for Doubler, which sends two messages
  EXPECT_EQ(out->count(), 0u);
  EXPECT_TRUE(bench().Step());
  EXPECT_EQ(out->values<int>(), Ints{42});
  while (bench().Step()) {
  }
  EXPECT_FALSE(bench().Step());
  EXPECT_EQ(bench().now_us(), 1000);  // nothing was left that is due later
}

TEST_F(RunTest, StepToAnObjectEndsAfterItsNextHandler) {
  bench().RunFor(1ms);
  in->Send(1);
  in->Send(2);  // waits for ready
  EXPECT_TRUE(bench().StepTo("Doubler"));
  EXPECT_EQ(out->count(), 0u);
  EXPECT_TRUE(bench().StepTo("Test2"));
  EXPECT_EQ(out->values<int>(), Ints{2});
}

TEST_F(RunTest, StepToAServiceOrAMessage) {
  bench().RunFor(1ms);
  in->Send(1);
  EXPECT_TRUE(bench().StepTo("Doubler.In"));
  EXPECT_TRUE(bench().StepTo("Test2.Out.int.O"));
  EXPECT_EQ(out->count(), 1u);
  in->Send(5);
  EXPECT_TRUE(bench().StepTo(Notify("Doubler.Out").With(Data<int>(10))));
  EXPECT_EQ(out->last<int>(), 10);
}

TEST_F(RunTest, StepToSaysWhatDidNotCome) {
  EXPECT_NONFATAL_FAILURE(EXPECT_FALSE(bench().StepTo("Doubler.Out", 1s)),
                          "StepTo: no message (any) -> Doubler.Out within 1 s");
  EXPECT_EQ(bench().now_us(), 1'000'000);
}

TEST_F(RunTest, AMisspeltNameIsAFailureNotSilence) {
  EXPECT_NONFATAL_FAILURE(bench().Disallow("Doubler.Owt", ""),
                          "There is no service 'Doubler.Owt' on this bench; did you mean "
                          "'Doubler.Out'?");
  EXPECT_NONFATAL_FAILURE(bench().Hold(Notify("", "Dubler")),
                          "There is no object 'Dubler' on this bench; did you mean 'Doubler'?");
}

TEST_F(RunTest, RunForMovesTheClock) {
  EXPECT_TRUE(bench().RunFor(12ms));
  EXPECT_EQ(bench().now_us(), 12'000);
}

TEST_F(RunTest, RunUntilStopsAtTheMessageThatMakesItTrue) {
  bench().RunFor(1ms);
  in->Send(1);
  EXPECT_TRUE(bench().RunUntil([&] { return out->count() == 1; }, 1s));
  EXPECT_EQ(bench().now_us(), 1000);
}

TEST_F(RunTest, RunUntilSaysWhatHappenedWhenItDoesNotHold) {
  bench().RunFor(1ms);
  in->Send(1);
  EXPECT_NONFATAL_FAILURE(bench().RunUntil([&] { return out->count() == 2; }, 2s),
                          "RunUntil: it does not hold within 2 s\n"
                          "t=2.001000 s.  Last messages:\n");
}

TEST_F(RunTest, AFailureTellsTheStory) {
  bench().RunFor(1ms);
  out->set_auto_ready(false);
  in->Send(1);
  bench().RunFor(9ms);
  in->Send(2);
  bench().RunFor(1ms);
  const std::string story = bench().Story();
  EXPECT_THAT(story,
              ::testing::HasSubstr(" t=0.001000 Test1.In -> Doubler.In notify, 4 bytes: 1\n"));
  EXPECT_THAT(story, ::testing::ContainsRegex(
                         "#([0-9]+) t=0.001000 Doubler.Out -> Test2.Out notify, 4 bytes, caused by "
                         "#[0-9]+: 2\n"));
  EXPECT_THAT(story, ::testing::HasSubstr("Who waits:\n  Doubler waits for ready"));
  EXPECT_THAT(story, ::testing::HasSubstr("since t=0.010 s"));
  EXPECT_THAT(story, ::testing::ContainsRegex(
                         "To see it again: OPENR_SEED=1 .*testing_tests "
                         "--gtest_filter=RunTest.AFailureTellsTheStory\n"
                         "  up to the last message: bench.StepToMessage\\([0-9]+\\)\n$"));
}

TEST_F(RunTest, StepToMessageComesToTheSameState) {
  bench().RunFor(1ms);
  in->Send(1);
  uint64_t number = 0;
  bench().OnMessage([&](const SeenMessage& message) { number = message.number(); });
  bench().RunFor(1ms);
  ASSERT_GT(number, 0u);
  const uint64_t hash = bench().trace_hash();

  BuildAndBoot();
  bench().RunFor(1ms);
  in->Send(1);
  EXPECT_TRUE(bench().StepToMessage(number));
  EXPECT_EQ(bench().trace_hash(), hash);
  EXPECT_NONFATAL_FAILURE(bench().StepToMessage(number), "does not come");
}

TEST_F(RunTest, AFrameEndsAtTheNextMultipleOfEightMilliseconds) {
  bench().RunFor(3ms);
  bench().Frame();
  EXPECT_EQ(bench().now_us(), 8000);
  bench().Frame(3);
  EXPECT_EQ(bench().now_us(), 32'000);
}

TEST_F(RunTest, WithoutABodyThereIsNoPhysics) {
  EXPECT_THROW(bench().PhysicsStep(), std::logic_error);
  EXPECT_THROW(bench().SensorVector(), std::logic_error);
}

TEST(BodyTest, ASensorVectorTakesFourFrames) {
  Bench bench({.body = "ideal"});
  ProbeObserver& sensors = bench.Watch("OVirtualRobotComm.Sensor.OSensorFrameVectorData.S");
  bench.Boot();
  bench.SensorVector();
  EXPECT_EQ(sensors.count(), 1u);
  EXPECT_EQ(bench.now_us(), 32'000);
  bench.RunFor(10ms);
  bench.SensorVector(2);
  EXPECT_EQ(sensors.count(), 3u);
  EXPECT_EQ(bench.now_us(), 96'000);
}

TEST(BodyTest, APhysicsStepEndsBeforeAnybodyHearsOfIt) {
  Bench bench({.body = "ideal"});
  ProbeObserver& sensors = bench.Watch("OVirtualRobotComm.Sensor.OSensorFrameVectorData.S");
  bench.Boot();
  for (int i = 0; i < 4; ++i) bench.PhysicsStep();
  EXPECT_EQ(bench.now_us(), 32'000);
  EXPECT_EQ(sensors.count(), 0u);  // on its way
  bench.Step();
  EXPECT_EQ(sensors.count(), 1u);
}

TEST(BodyTest, BeforeBootTheBodyStandsStill) {
  Bench bench({.body = "ideal"});
  EXPECT_NONFATAL_FAILURE(bench.PhysicsStep(),
                          "PhysicsStep: the body stands still; is the robot booted?");
  EXPECT_NONFATAL_FAILURE(bench.SensorVector(),
                          "SensorVector: the body stands still; is the robot booted?");
}

}  // namespace
}  // namespace openr::testing
