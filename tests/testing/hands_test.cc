// Tests of a person's hands: they press the dog's sensors, push it, lift it, change its battery.
#include <gtest/gtest-spi.h>
#include <openr/testing.h>

#include <string>
#include <vector>

#include "virtualrobot/body/body.h"
#include "virtualrobot/virtual_robot.h"

namespace openr::testing {
namespace {

// The default stick on a body: it stands up by itself.
BenchOptions Dog(const std::string& body) { return {.stick = DefaultStick(), .body = body}; }

// The height of the dog's base.
double HeightOf(const Bench& bench) { return bench.dog().body().state().X_WB.translation().z(); }

TEST(HandsTest, APressIsReadAsLongAsItLasts) {
  Bench bench(Dog("ideal"));
  bench.Boot();
  bench.RunFor(80ms);
  EXPECT_TRUE(bench.Press("chin", 24ms));
  std::vector<int64_t> values;
  for (int i = 0; i < 5; ++i) {
    bench.Frame();
    values.push_back(bench.SensorValue("chin"));
  }
  EXPECT_EQ(values, (std::vector<int64_t>{1, 1, 1, 0, 0}));
}

TEST(HandsTest, APressWithoutADurationLastsUntilTheRelease) {
  Bench bench(Dog("ideal"));
  bench.Boot();
  EXPECT_TRUE(bench.Press("back"));
  bench.RunFor(1s);
  EXPECT_EQ(bench.SensorValue("back"), 1);
  EXPECT_TRUE(bench.Release("back"));
  bench.RunFor(16ms);
  EXPECT_EQ(bench.SensorValue("back"), 0);
}

TEST(HandsTest, OneWordNamesBothSensorsOfTheHead) {
  Bench bench(Dog("ideal"));
  bench.Boot();
  EXPECT_TRUE(bench.Do("press head 10%"));
  bench.RunFor(16ms);
  EXPECT_EQ(bench.SensorValue("head_front"), 98066);
  EXPECT_EQ(bench.SensorValue("head_back"), 98066);
}

TEST(HandsTest, ASensorReadsTheValueThatIsSet) {
  Bench bench(Dog("ideal"));
  bench.Boot();
  EXPECT_TRUE(bench.SetSensor("distance", 123'456));
  bench.RunFor(16ms);
  EXPECT_EQ(bench.SensorValue("distance"), 123'456);
}

TEST(HandsTest, TheOtherSensorsHaveTheSameNoiseWhenOneIsSet) {
  const auto distances = [](bool sets) {
    Bench bench(Dog("ideal"));
    bench.Boot();
    if (sets) bench.SetSensor("temperature", 40'000'000);
    std::vector<int64_t> values;
    for (int i = 0; i < 20; ++i) {
      bench.Frame();
      values.push_back(bench.SensorValue("distance"));
    }
    return values;
  };
  EXPECT_EQ(distances(true), distances(false));
}

TEST(HandsTest, InputsThatCannotBeAreRefused) {
  Bench bench(Dog("ideal"));
  bench.Boot();
  const auto why = [&](const char* line) { return bench.system().inputs().Check(0, line); };
  EXPECT_EQ(why("press chinn"),
            "press: the ERS-210 has no sensor 'chinn'; did you mean 'chin'?; it has head_back, "
            "head_front, distance, chin, paw_LF, paw_LH, paw_RF, paw_RH, temperature, back, "
            "acceleration_x, acceleration_y, acceleration_z; usage: press SENSOR [N%] [for "
            "DURATION], or press pause");
  EXPECT_THAT(why("press"), ::testing::HasSubstr("needs one sensor"));
  EXPECT_THAT(why("press distance"), ::testing::HasSubstr("nobody can press 'distance'; use set"));
  EXPECT_THAT(why("press chin 101%"), ::testing::HasSubstr("no percentage from 0% to 100%"));
  EXPECT_THAT(why("press chin for 3"), ::testing::HasSubstr("'3' has no unit"));
  EXPECT_THAT(why("set neck_tilt 5"), ::testing::HasSubstr("is a joint"));
  EXPECT_THAT(why("set distance 5"), ::testing::HasSubstr("outside of what distance measures"));
  EXPECT_THAT(why("set distance x"), ::testing::HasSubstr("no whole number"));
  EXPECT_THAT(why("push 1 2"), ::testing::HasSubstr("needs three numbers"));
  EXPECT_THAT(why("push 1 2 3"), ::testing::HasSubstr("use --body ode"));
  EXPECT_THAT(why("push 1 2 3 at heda"), ::testing::HasSubstr("did you mean 'head'?"));
  EXPECT_THAT(why("push nan 2 3"), ::testing::HasSubstr("'nan' is no number"));
  EXPECT_THAT(why("push 1e9 0 0"), ::testing::HasSubstr("limited to 1000 N"));
  EXPECT_THAT(why("lift -1"), ::testing::HasSubstr("out of range"));
  EXPECT_THAT(why("battery 101%"), ::testing::HasSubstr("no percentage"));
  EXPECT_THAT(why("charger maybe"), ::testing::HasSubstr("neither on nor off"));
  EXPECT_THAT(why("hold it"), ::testing::HasSubstr("takes no 'it'"));
  EXPECT_THAT(why("pres chin"), ::testing::HasSubstr("'pres' is no input; did you mean 'press'?"));
  EXPECT_EQ(bench.system().inputs().NextUs(), INT64_MAX);
}

TEST(HandsTest, ARefusedInputFailsAtTheLineOfTheTest) {
  Bench bench(Dog("ideal"));
  bench.Boot();
  EXPECT_NONFATAL_FAILURE(EXPECT_FALSE(bench.Press("nose")), "has no sensor 'nose'");
}

TEST(HandsTest, ABenchWithoutABodyRefusesTheInputsOfBodies) {
  Bench bench;
  bench.Boot();
  EXPECT_NONFATAL_FAILURE(bench.Press("chin"), "'press' is no input");
}

TEST(HandsTest, APushMovesThePhysicalDogTheWayItPoints) {
  const auto sideways_m = [](double force_n) {
    Bench bench(Dog("ode"));
    bench.Boot();
    bench.RunFor(15s);
    const double before_m = bench.dog().body().state().X_WB.translation().y();
    EXPECT_TRUE(bench.Push({0, force_n, 0}, 200ms));
    bench.RunFor(200ms);
    return bench.dog().body().state().X_WB.translation().y() - before_m;
  };
  const double nothing_m = sideways_m(0);
  EXPECT_GT(sideways_m(8), nothing_m + 0.002);
  EXPECT_LT(sideways_m(-8), nothing_m - 0.002);
}

// A dog that stands on the floor.
class LiftTest : public ::testing::TestWithParam<const char*> {
 protected:
  LiftTest() : bench(Dog(GetParam())) {
    bench.Boot();
    bench.RunFor(15s);
    on_floor_m = HeightOf(bench);
  }

  Bench bench;
  double on_floor_m = 0;
};
INSTANTIATE_TEST_SUITE_P(Bodies, LiftTest, ::testing::Values("ideal", "ode"));

TEST_P(LiftTest, ALiftedDogHangsLevelAndIsSetDownAgain) {
  EXPECT_TRUE(bench.Lift(0.15));
  bench.RunFor(2s);
  EXPECT_NEAR(HeightOf(bench), on_floor_m + 0.15, 0.01);
  EXPECT_NEAR(bench.RollDeg(), 0, 3);
  for (const bool touches : bench.dog().body().state().paws) EXPECT_FALSE(touches);
  EXPECT_EQ(bench.SensorValue("paw_LF"), 0);
  EXPECT_TRUE(bench.SetDown());
  bench.Frame();
  EXPECT_TRUE(bench.RunUntil([&] { return !bench.dog().parts().hands.is_holding(); }, 5s));
  EXPECT_LT(HeightOf(bench), on_floor_m + 0.01);  // the hand has not dropped the dog
  bench.RunFor(1s);
  EXPECT_NEAR(HeightOf(bench), on_floor_m, 0.005);
  EXPECT_TRUE(bench.Standing());
}

TEST_P(LiftTest, ADogThatIsLetGoFalls) {
  EXPECT_TRUE(bench.Lift(0.1));
  bench.RunFor(2s);
  EXPECT_TRUE(bench.HoldDog());
  bench.RunFor(500ms);
  EXPECT_NEAR(HeightOf(bench), on_floor_m + 0.1, 0.01);
  EXPECT_TRUE(bench.LetGo());
  bench.RunFor(2s);
  EXPECT_LT(HeightOf(bench), on_floor_m + 0.03);
}

TEST(HandsTest, AnEmptyBatteryEndsTheRun) {
  Bench bench(Dog("ideal"));
  bench.Boot();
  bench.RunFor(1s);
  EXPECT_TRUE(bench.SetBattery(9));
  bench.RunFor(3s);
  ASSERT_TRUE(bench.system().end());
  EXPECT_EQ(bench.system().end()->kind, openr_host::EndKind::kBattery);
}

TEST(HandsTest, TheChargingStationShowsInThePowerStatusAndFillsTheBattery) {
  Bench bench({.stick = DefaultStick(), .body = "ideal", .battery = "50%"});
  bench.Boot();
  EXPECT_TRUE(bench.SetCharger(true));
  bench.RunFor(100ms);
  OPowerStatus status = bench.dog().parts().power.Status();
  EXPECT_TRUE(status.robotStatus & orsbSTATION_CONNECTED);
  EXPECT_TRUE(status.robotStatus & orsbBATTERY_CHARGING);
  EXPECT_FALSE(status.batteryStatus & obsbDISCHARGING);
  EXPECT_GT(status.current, 0);
  bench.RunFor(145s);
  EXPECT_EQ(bench.dog().parts().power.remaining_percent(), 52);
  EXPECT_TRUE(bench.SetCharger(false));
  bench.RunFor(100ms);
  status = bench.dog().parts().power.Status();
  EXPECT_FALSE(status.robotStatus & orsbSTATION_CONNECTED);
  EXPECT_TRUE(status.batteryStatus & obsbDISCHARGING);
  EXPECT_EQ(status.remainingCapacity, 52);
}

TEST(HandsTest, HandsThatActArePartOfTheState) {
  const auto hash = [](const char* input) {
    Bench bench(Dog("ideal"));
    bench.Boot();
    bench.RunFor(80ms);
    if (*input != '\0') bench.Do(input);
    const uint64_t waiting = bench.state_hash();
    bench.RunFor(80ms);
    return std::pair(waiting, bench.state_hash());
  };
  const auto plain = hash("");
  for (const char* const input :
       {"press chin", "press chin for 1s", "lift", "battery 40%", "charger on"}) {
    EXPECT_NE(hash(input).first, plain.first) << input;
    EXPECT_NE(hash(input).second, plain.second) << input;
  }
  EXPECT_NE(hash("press chin").second, hash("press chin for 1s").second);
}

}  // namespace
}  // namespace openr::testing
