// Faults of the dog: joints that are turned by hand, jammed, weak or without power, sensors that
// are stuck, noisy or dead, heat and current.
#include <openr/testing.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/temp_folder.h"
#include "virtualrobot/body/body.h"
#include "virtualrobot/virtual_robot.h"

namespace openr::testing {
namespace {

using ::testing::HasSubstr;

// The default stick on a body: it stands up by itself within 15 s.
BenchOptions FaultyDog(const std::string& body, const std::string& robot = "ers210") {
  return {.stick = DefaultStick(), .body = body, .robot = robot};
}

int CountFindingsWith(Bench& bench, const std::string& text) {
  const auto& findings = bench.system().findings().all();
  return static_cast<int>(std::count_if(findings.begin(), findings.end(), [&](const auto& finding) {
    return finding.text.find(text) != std::string::npos;
  }));
}

std::vector<std::string> FaultsOf(const Bench& bench) {
  return bench.dog().parts().faults.Present();
}

class TurnTest : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Bodies, TurnTest, ::testing::Values("ideal", "ode"));

TEST_P(TurnTest, AHandTurnsTheHeadAgainstItsServoUntilItLetsGo) {
  Bench bench(FaultyDog(GetParam()));
  bench.Boot();
  bench.RunFor(15s);
  const double before_deg = bench.JointDeg("neck_pan");
  EXPECT_TRUE(bench.Do("turn neck_pan 40"));
  bench.RunFor(240ms);
  EXPECT_NEAR(bench.JointDeg("neck_pan"), before_deg + 21.6, 3);  // with 90 degrees/s
  bench.RunFor(2s);
  EXPECT_NEAR(bench.JointDeg("neck_pan"), 40, 1);
  EXPECT_TRUE(bench.Release("neck_pan"));
  bench.RunFor(2s);
  // The servo has worked against the hand for two seconds, and its sum of errors goes back slowly.
  EXPECT_NEAR(bench.JointDeg("neck_pan"), before_deg, 2.5);
}

TEST_P(TurnTest, AHandLetsGoWhenItsTimeIsOver) {
  Bench bench(FaultyDog(GetParam()));
  bench.Boot();
  bench.RunFor(15s);
  EXPECT_TRUE(bench.Do("turn neck_pan 20 for 1s"));
  bench.RunFor(992ms);
  EXPECT_NEAR(bench.JointDeg("neck_pan"), 20, 1);
  bench.RunFor(2s);
  EXPECT_NEAR(bench.JointDeg("neck_pan"), 0, 2.5);
}

TEST(FaultsTest, AHandHasNotTheStrengthToHoldAStrongerMotor) {
  Bench bench(FaultyDog("ode"));
  bench.Boot();
  bench.RunFor(15s);
  // The weight of a quarter of the dog, and the motor, press against the hand.
  EXPECT_TRUE(bench.Do("turn LF_j1 60"));
  bench.RunFor(500ms);
  const openr_host::JointState& joint =
      bench.dog().body().state().joints[static_cast<size_t>(bench.model().FindJoint("LF_j1"))];
  EXPECT_GT(std::fabs(joint.drive), 50);  // the servo works against the hand
}

TEST_P(TurnTest, AJammedJointStaysWhereItIs) {
  Bench bench(FaultyDog(GetParam()));
  bench.Boot();
  const double lying_deg = bench.JointDeg("LF_j1");
  EXPECT_TRUE(bench.Do("break LF_j1 jammed"));
  bench.AllowFindings();
  bench.RunFor(15s);
  EXPECT_NEAR(bench.JointDeg("LF_j1"), lying_deg, 0.2);
  EXPECT_FALSE(bench.Standing());
  EXPECT_EQ(FaultsOf(bench), std::vector<std::string>{"LF_j1 jammed"});
  EXPECT_TRUE(bench.Do("repair LF_j1"));
  bench.RunFor(5s);
  EXPECT_NEAR(bench.JointDeg("LF_j1"), -10, 3);
  EXPECT_TRUE(FaultsOf(bench).empty());
}

TEST(FaultsTest, AWeakLegSagsAndARepairedOneStands) {
  Bench bench(FaultyDog("ode"));
  bench.Boot();
  bench.RunFor(15s);
  bench.AllowFindings();
  const double standing_deg = bench.JointDeg("LF_j3");
  EXPECT_TRUE(bench.Do("break LF_j3 weak 2%"));
  bench.RunFor(4s);
  EXPECT_GT(std::fabs(bench.JointDeg("LF_j3") - standing_deg), 3);
  EXPECT_TRUE(bench.Do("repair all"));
  bench.RunFor(4s);
  EXPECT_NEAR(bench.JointDeg("LF_j3"), standing_deg, 1.5);
}

// The control law does not know that its motor has no power, and goes on asking for more.
TEST(FaultsTest, AJointWithoutPowerHangsWhileItsServoAsksForMore) {
  Bench bench(FaultyDog("ode"));
  bench.Boot();
  bench.RunFor(15s);
  EXPECT_TRUE(bench.Do("break neck_tilt unpowered for 30s"));
  bench.RunFor(3s);
  EXPECT_LT(bench.JointDeg("neck_tilt"), -40);
  const auto tilt = static_cast<size_t>(bench.model().FindJoint("neck_tilt"));
  EXPECT_GT(bench.dog().body().state().joints[tilt].drive, 20);
}

TEST(FaultsTest, AStuckSensorKeepsItsValue) {
  Bench bench(FaultyDog("ideal"));
  bench.Boot();
  bench.RunFor(80ms);
  EXPECT_TRUE(bench.Do("break distance stuck"));
  bench.Frame();
  const int64_t value = bench.SensorValue("distance");
  EXPECT_TRUE(bench.SetSensor("distance", value == 300'000 ? 400'000 : 300'000));
  bench.RunFor(1s);
  EXPECT_EQ(bench.SensorValue("distance"), value);
  EXPECT_TRUE(bench.Do("repair distance"));
  bench.Frame(2);
  EXPECT_NE(bench.SensorValue("distance"), value);
}

TEST(FaultsTest, ADeadSensorReadsTheMarksOfMissingData) {
  Bench bench(FaultyDog("ideal"));
  bench.Boot();
  bench.RunFor(80ms);
  EXPECT_TRUE(bench.Do("break acceleration_z dead for 16ms"));
  bench.Frame();
  const int index = bench.model().SensorsNamed("acceleration_z").front();
  EXPECT_EQ(bench.dog().sensor(index).value, opsdINVALID_VALUE);
  EXPECT_EQ(bench.dog().sensor(index).signal, osensorframeINVALID_SIGNAL);
  bench.Frame(2);
  EXPECT_LT(bench.dog().sensor(index).value, -9'000'000);
  EXPECT_EQ(bench.dog().sensor(index).signal, 0);
}

TEST(FaultsTest, ANoisySensorStaysWithinItsNoise) {
  Bench bench(FaultyDog("ideal"));
  bench.Boot();
  bench.RunFor(15s);
  const double before = static_cast<double>(bench.SensorValue("acceleration_x"));
  EXPECT_TRUE(bench.Do("break acceleration_x noisy 5%"));
  const double highest = 0.05 * 2 * 19'613'300;
  double largest = 0;
  for (int i = 0; i < 200; ++i) {
    bench.Frame();
    largest = std::max(
        largest, std::fabs(static_cast<double>(bench.SensorValue("acceleration_x")) - before));
  }
  EXPECT_LE(largest, highest);
  EXPECT_GT(largest, 0.8 * highest);
}

TEST(FaultsTest, ANoisySwitchIsWrongNowAndThen) {
  Bench bench(FaultyDog("ideal"));
  bench.Boot();
  EXPECT_TRUE(bench.Do("break chin noisy 20%"));
  int presses = 0;
  for (int i = 0; i < 500; ++i) {
    bench.Frame();
    presses += static_cast<int>(bench.SensorValue("chin"));
  }
  EXPECT_GT(presses, 60);
  EXPECT_LT(presses, 140);
}

TEST(FaultsTest, OtherSensorsDoNotChangeWhenOneIsNoisy) {
  const auto distances = [](bool breaks) {
    Bench bench(FaultyDog("ideal"));
    bench.Boot();
    if (breaks) bench.Do("break acceleration_x noisy 10%");
    std::vector<int64_t> values;
    for (int i = 0; i < 20; ++i) {
      bench.Frame();
      values.push_back(bench.SensorValue("distance"));
    }
    return values;
  };
  EXPECT_EQ(distances(true), distances(false));
}

// The servo of a joint has no other sensor than the one that broke.
TEST(FaultsTest, AJointWithAStuckSensorRunsAwayWhenItIsToMove) {
  Bench bench(FaultyDog("ode"));
  bench.Boot();
  bench.RunFor(15s);
  bench.AllowFindings();
  EXPECT_TRUE(bench.Do("turn neck_pan 10"));  // so that the servo sees an error
  bench.RunFor(1s);
  EXPECT_TRUE(bench.Do("break neck_pan stuck"));
  EXPECT_TRUE(bench.Do("release neck_pan"));
  bench.RunFor(4s);
  EXPECT_LT(bench.JointDeg("neck_pan"), -85);
  const int index = bench.model().SensorsNamed("neck_pan").front();
  EXPECT_NEAR(static_cast<double>(bench.dog().sensor(index).value), 10 * 17453.3, 20'000);
}

TEST(FaultsTest, FaultsThatCannotBeAreRefused) {
  Bench bench(FaultyDog("ideal"));
  bench.Boot();
  const auto why = [&](const char* line) { return bench.system().inputs().Check(0, line); };
  EXPECT_THAT(why("break"), HasSubstr("needs a joint, a sensor or a locator, and a fault"));
  EXPECT_THAT(why("break LF_j9 jammed"), HasSubstr("no joint or sensor 'LF_j9'; did you mean"));
  EXPECT_THAT(why("break LF_j1 jamed"), HasSubstr("'jamed' is no fault; did you mean 'jammed'?"));
  EXPECT_THAT(why("break chin jammed"), HasSubstr("'chin' is a sensor and no joint"));
  EXPECT_THAT(why("break LF_j1 weak"), HasSubstr("weak needs one percentage"));
  EXPECT_THAT(why("break LF_j1 weak 120%"), HasSubstr("no percentage from 0% to 100%"));
  EXPECT_THAT(why("break LF_j1 dead 5%"), HasSubstr("dead needs nothing more"));
  EXPECT_THAT(why("break chin missing 5%"), HasSubstr("missing needs nothing more"));
  EXPECT_THAT(why("break nose missing"), HasSubstr("no joint or sensor 'nose'"));
  EXPECT_THAT(why("break chin dead for 3"), HasSubstr("'3' has no unit"));
  EXPECT_THAT(why("repair"), HasSubstr("needs one joint, sensor or locator, body, battery or all"));
  EXPECT_THAT(why("repair nose"), HasSubstr("no joint or sensor 'nose'"));
  EXPECT_THAT(why("heat nose 40"), HasSubstr("needs body or battery"));
  EXPECT_THAT(why("heat body 400"), HasSubstr("'400' is no whole number from -20 to 120"));
  EXPECT_THAT(why("draw 0"), HasSubstr("'0' is no whole number from 1 to 30000"));
  EXPECT_THAT(why("turn chin 5"), HasSubstr("no joint 'chin'"));
  EXPECT_THAT(why("turn neck_pan 95"),
              HasSubstr("95 degrees is beyond the stops of neck_pan, -92.6 to 92.6"));
  EXPECT_THAT(why("turn neck_pan"), HasSubstr("needs one joint and one angle"));
  EXPECT_EQ(bench.system().inputs().NextUs(), INT64_MAX);
}

TEST(FaultsTest, ARunWithoutFaultsIsTheSameAsOneWhoseFaultsAreOver) {
  const auto hash = [](bool breaks) {
    Bench bench(FaultyDog("ideal"));
    bench.Boot();
    if (breaks) bench.Do("break chin dead for 80ms");
    bench.RunFor(2s);
    return bench.state_hash();
  };
  EXPECT_EQ(hash(true), hash(false));
}

TEST(FaultsTest, WithoutAJointTheDefaultStickMovesNothingAndGoesOn) {
  Bench bench(FaultyDog("ideal"));
  EXPECT_TRUE(bench.Do("break LF_j1 missing"));
  bench.ExpectFinding(HasSubstr("DoInit"));
  bench.Boot();
  const double before_deg = bench.JointDeg("LH_j3");
  bench.RunFor(2s);
  EXPECT_EQ(bench.JointDeg("LH_j3"), before_deg);
  EXPECT_EQ(bench.SensorValue("chin"), 0);
}

TEST(FaultsTest, FaultsAndRepairsOfTimeZeroComeBeforeTheBootInTheOrderOfTheirLines) {
  Bench bench(FaultyDog("ideal"));
  EXPECT_TRUE(bench.Do("break LF_j1 missing"));
  EXPECT_TRUE(bench.Do("break LF_j1 weak 20%"));
  EXPECT_TRUE(bench.Do("repair all"));
  EXPECT_TRUE(bench.Do("break chin stuck"));
  bench.Boot();  // a missing joint would be a finding, because DoInit of JointMover would fail
  EXPECT_EQ(FaultsOf(bench), std::vector<std::string>{"chin stuck"});
}

TEST(FaultsTest, APartThatBreaksAfterARepairOfTimeZeroIsMissingInTheBoot) {
  Bench bench(FaultyDog("ideal"));
  EXPECT_TRUE(bench.Do("repair LF_j1"));
  EXPECT_TRUE(bench.Do("break LF_j1 missing"));
  bench.ExpectFinding(HasSubstr("DoInit"));
  bench.Boot();
  EXPECT_EQ(FaultsOf(bench), std::vector<std::string>{"LF_j1 missing"});
}

// ---- heat and current

TEST(HeatTest, TheThermometerReadsTheHeatOfTheBody) {
  Bench bench(FaultyDog("ideal"));
  bench.Boot();
  bench.RunFor(1s);
  EXPECT_EQ(bench.SensorValue("temperature"), 30'000'000);
  EXPECT_TRUE(bench.Do("heat body 45 for 1s"));
  bench.RunFor(500ms);
  EXPECT_EQ(bench.SensorValue("temperature"), 45'000'000);
  bench.RunFor(20min);  // two time constants
  EXPECT_EQ(bench.SensorValue("temperature"), 32'000'000);
}

// The status of the power, without the bits that a healthy robot has.
struct PowerBits {
  longword robot;
  word battery;
};
PowerBits BitsOf(const Bench& bench) {
  const OPowerStatus status = bench.dog().power().Status();
  return {status.robotStatus & (orsbBATTERY_OVER_CURRENT | orsbBATTERY_OVER_TEMP_DISCHARGING |
                                orsbBATTERY_OVER_TEMP_CHARGING),
          static_cast<word>(status.batteryStatus & obsbOVER_TEMP_ALARM)};
}

TEST(HeatTest, AHotBatteryIsAnErrorAndABitOfThePowerStatus) {
  Bench bench(FaultyDog("ideal"));
  bench.Boot();
  bench.RunFor(1s);
  EXPECT_TRUE(bench.Do("heat battery 69"));
  bench.RunFor(1s);
  EXPECT_EQ(bench.dog().power().Status().temperature, 2731 + 690);
  EXPECT_EQ(BitsOf(bench).robot, 0u);
  bench.ExpectFinding(HasSubstr(
      "BATTERY_OVER_TEMP_DISCHARGING: the battery has 70 degrees Celsius, its limit is 70"));
  EXPECT_TRUE(bench.Do("heat battery 70"));
  bench.RunFor(1s);
  EXPECT_EQ(BitsOf(bench).robot, orsbBATTERY_OVER_TEMP_DISCHARGING);
  EXPECT_EQ(BitsOf(bench).battery, obsbOVER_TEMP_ALARM);
  EXPECT_FALSE(bench.system().powered_off());  // only with `strict`
  EXPECT_TRUE(bench.Do("repair battery"));
  bench.RunFor(2min);
  EXPECT_EQ(BitsOf(bench).robot, 0u);
}

TEST(HeatTest, TheLimitIsLowerOnTheStation) {
  Bench bench(FaultyDog("ideal"));
  bench.Boot();
  bench.SetCharger(true);
  bench.ExpectFinding(HasSubstr("BATTERY_OVER_TEMP_CHARGING"));
  EXPECT_TRUE(bench.Do("heat battery 65"));
  bench.RunFor(1s);
  EXPECT_EQ(BitsOf(bench).robot, orsbBATTERY_OVER_TEMP_CHARGING);
}

// field-notes.md 7.22: walking on the mains adapter.  The load of a hard walk is `draw` here; our
// own walk needs too little current for that.
TEST(HeatTest, UnderLoadTheBatteryIsTooHotSoonerOnTheStation) {
  for (const bool on_station : {true, false}) {
    Bench bench(FaultyDog("ideal"));
    bench.Boot();
    bench.AllowFindings();
    bench.SetCharger(on_station);
    EXPECT_TRUE(bench.Do("draw 4000"));
    bench.RunFor(12min);
    EXPECT_EQ(CountFindingsWith(bench, "BATTERY_OVER_TEMP_"), on_station ? 1 : 0);
  }
}

TEST(HeatTest, AStrictRobotWithAHotBatteryShutsDownAndStopsItsObjects) {
  BenchOptions options = FaultyDog("ideal", "ers7");
  options.strict = true;
  Bench bench(options);
  bench.Boot();
  bench.RunFor(1s);
  bench.ExpectFinding(HasSubstr("its limit is 65"));
  EXPECT_TRUE(bench.Do("heat battery 65"));
  bench.RunFor(1s);
  EXPECT_TRUE(bench.system().powered_off());
  EXPECT_EQ(bench.system().end()->why, "the battery had 65 degrees Celsius");
}

TEST(HeatTest, TooMuchCurrentIsAnError) {
  Bench bench(FaultyDog("ideal"));
  bench.Boot();
  bench.RunFor(1s);
  EXPECT_EQ(bench.dog().power().Status().current, -1300);
  EXPECT_TRUE(bench.Do("draw 6000 for 1s"));
  bench.RunFor(500ms);
  EXPECT_EQ(bench.dog().power().Status().current, -7300);
  bench.RunFor(1s);
  bench.ExpectFinding(HasSubstr("BATTERY_OVER_CURRENT: the battery gives"));
  EXPECT_TRUE(bench.Do("draw 9000 for 1s"));
  bench.RunFor(500ms);
  EXPECT_EQ(BitsOf(bench).robot, orsbBATTERY_OVER_CURRENT);
  bench.RunFor(2s);
  EXPECT_EQ(BitsOf(bench).robot, 0u);
}

// field-notes.md 7.21: fast reversals.  A motor that turns back at each frame never gets the speed
// that would lower its current.
TEST(HeatTest, LegsThatReverseAtEachFrameDrawTooMuchCurrent) {
  const auto targets = [](int j1_deg, int j2_deg, int j3_deg) {
    std::string line = "target";
    for (const char* leg : {"LF", "LH", "RF", "RH"}) {
      for (const auto& [joint, deg] : {std::pair("j1", j1_deg), {"j2", j2_deg}, {"j3", j3_deg}})
        line += std::string(" ") + leg + "_" + joint + " " + std::to_string(deg);
    }
    return line;
  };
  for (const auto frames : {1, 20}) {
    Bench bench(FaultyDog("ode"));
    bench.Boot();
    bench.RunFor(15s);
    bench.AllowFindings();
    for (int i = 0; i < 800 / frames / 8; ++i) {
      EXPECT_TRUE(bench.Do(i % 2 == 0 ? targets(60, 60, 100) : targets(-60, 0, 0)));
      bench.RunFor(frames * 8ms);
    }
    const int found = CountFindingsWith(bench, "BATTERY_OVER_CURRENT: the battery gives");
    EXPECT_EQ(found > 0, frames == 1) << frames;
  }
}

TEST(HeatTest, AShortPeakOfCurrentIsNone) {
  Bench bench(FaultyDog("ideal"));
  bench.Boot();
  bench.RunFor(1s);
  EXPECT_TRUE(bench.Do("draw 9000 for 24ms"));
  bench.RunFor(1s);  // a finding would fail the test
}

TEST(HeatTest, AHigherCurrentDrainsTheBatterySooner) {
  Bench bench(FaultyDog("ideal"));
  bench.Boot();
  EXPECT_TRUE(bench.Do("draw 1300"));
  bench.RunFor(275s);  // 5 % at the usual current
  EXPECT_EQ(bench.dog().power().remaining_percent(), 90);
}

// ---- protection by model

TEST(JamTest, AnErs7ShutsDownWhenAJointIsJammed) {
  Bench bench(FaultyDog("ode", "ers7"));
  bench.Boot();
  bench.AllowFindings();
  EXPECT_TRUE(bench.Do("break LF_j1 jammed"));  // while the dog is to stand up
  bench.ExpectFinding(HasSubstr("JAM. SHUTDOWN.: LF_j1"));
  bench.RunFor(15s);
}

// field-notes.md 7.20.  Without the file the robot shuts down after a second, as the test above
// shows.
TEST(JamTest, VrcommCfgMakesAnErs7MorePatient) {
  for (const char* conf : {"MW", "SYSTEM"}) {
    const openr_host::TempFolder folder;
    std::filesystem::copy(DefaultStick(), folder.path() + "/stick",
                          std::filesystem::copy_options::recursive);
    const std::string place = folder.path() + "/stick/OPEN-R/" + conf + "/CONF";
    std::filesystem::create_directories(place);
    std::ofstream(place + "/VRCOMM.CFG") << "JamDetectionHighThreshold\r\n";
    BenchOptions options = FaultyDog("ode", "ers7");
    options.stick = folder.path() + "/stick";
    Bench bench(options);
    bench.Boot();
    bench.AllowFindings();
    EXPECT_TRUE(bench.Do("break LF_j1 jammed"));  // while the dog is to stand up
    bench.RunFor(4s);
    EXPECT_EQ(CountFindingsWith(bench, "JamDetectionHighThreshold: a joint may be jammed for 5000"),
              1);
    EXPECT_EQ(CountFindingsWith(bench, "JAM. SHUTDOWN."), 0);
    bench.RunFor(11s);
    EXPECT_GE(CountFindingsWith(bench, "JAM. SHUTDOWN.: LF_j1"), 1);
  }
}

// A file that does not ask for it, and a robot that does not look for jams.
TEST(JamTest, OtherVrcommCfgChangesNothing) {
  const openr_host::TempFolder folder;
  std::filesystem::copy(DefaultStick(), folder.path() + "/stick",
                        std::filesystem::copy_options::recursive);
  const std::string file = folder.path() + "/stick/OPEN-R/MW/CONF/VRCOMM.CFG";
  std::ofstream(file) << "# JamDetectionHighThreshold\n[ERS-210]\nJamDetectionHighThreshold\n";
  for (const char* robot : {"ers7", "ers210"}) {
    BenchOptions options = FaultyDog("ode", robot);
    options.stick = folder.path() + "/stick";
    Bench bench(options);
    bench.Boot();
    EXPECT_EQ(CountFindingsWith(bench, "JamDetectionHighThreshold"), 0) << robot;
  }
}

}  // namespace
}  // namespace openr::testing
