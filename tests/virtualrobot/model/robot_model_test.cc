#include "virtualrobot/model/robot_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host {
namespace {

std::string TextOf(const std::string& file) {
  std::ifstream in(std::string(OPENR_MODEL_DIR) + "/" + file);
  return {std::istreambuf_iterator<char>(in), {}};
}

using Changes = std::vector<std::pair<std::string, std::string>>;

// Returns the model of the ERS-210 with pieces of its text changed.
std::string Changed(const Changes& changes) {
  std::string text = TextOf("ers210.json");
  for (const auto& [before, after] : changes) {
    const size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    text.replace(at, before.size(), after);
  }
  return text;
}

// The ERS-210 with one piece of text changed, and what the loader says to it.
std::string ErrorWith(const std::string& before, const std::string& after) {
  const std::string text = Changed({{before, after}});
  return ErrorOf([&] { ParseRobotModel(text, "m.json"); });
}

TEST(RobotModelTest, Ers210WeighsWhatItsBlocksWeigh) {
  EXPECT_NEAR(Ers210().TotalMassKg(), 1.612, 1e-12);  // Hohl 2004, table 3.1
}

TEST(RobotModelTest, Ers210Has18Joints31Sensors9LightsAnd2Ears) {
  EXPECT_EQ(Ers210().joints.size(), 18u);
  EXPECT_EQ(Ers210().sensors.size(), 31u);
  EXPECT_EQ(Ers210().leds.size(), 9u);
  EXPECT_EQ(Ers210().plungers.size(), 2u);
  EXPECT_EQ(Ers210().paws.size(), 4u);
}

TEST(RobotModelTest, AllModelsLoadAndNameTheirDesign) {
  EXPECT_EQ(ModelNamed("ers210.json").design, "ERS-210");
  EXPECT_EQ(ModelNamed("ers220.json").design, "ERS-220");
  EXPECT_EQ(ModelNamed("ers7.json").design, "ERS-7");
}

TEST(RobotModelTest, EveryJointFindsItselfThroughItsSensor) {
  for (const char* file : {"ers210.json", "ers220.json", "ers7.json"}) {
    const RobotModel model = ModelNamed(file);
    for (size_t j = 0; j < model.joints.size(); ++j) {
      const Sensor& sensor = model.sensors[model.joints[j].sensor];
      EXPECT_EQ(sensor.joint, static_cast<int>(j)) << model.joints[j].name;
      EXPECT_EQ(sensor.locator, model.joints[j].locator);
    }
  }
}

TEST(RobotModelTest, SensorRangesOfJointsAreTheirStops) {
  for (const Sensor& sensor : Ers210().sensors) {
    if (sensor.joint < 0) continue;
    const JointModel& joint = Ers210().joints[sensor.joint];
    EXPECT_NEAR(joint.hard_rad.min * 1e6, sensor.min, 0.6) << joint.name;
    EXPECT_NEAR(joint.hard_rad.max * 1e6, sensor.max, 0.6) << joint.name;
  }
}

// field-notes.md 7.18: Sony's support corrected the tables of two robots.  The table of the ERS-7
// has left and right legs where it means fore and hind legs.
TEST(RobotModelTest, TheCorrectionsOfSonysTablesHold) {
  const RobotModel ers7 = ModelNamed("ers7.json");
  for (const char* side : {"L", "R"}) {
    const auto limits = [&](const char* leg) {
      const int joint = ers7.FindJoint(std::string(side) + leg);
      return ers7.joints.at(static_cast<size_t>(joint)).soft_rad;
    };
    EXPECT_NEAR(limits("F_j1").min, Radians(-115), 1e-9) << side;
    EXPECT_NEAR(limits("F_j1").max, Radians(130), 1e-9) << side;
    EXPECT_NEAR(limits("H_j1").min, Radians(-130), 1e-9) << side;
    EXPECT_NEAR(limits("H_j1").max, Radians(115), 1e-9) << side;
  }
  const RobotModel ers220 = ModelNamed("ers220.json");
  const JointModel& tilt = ers220.joints.at(static_cast<size_t>(ers220.FindJoint("neck_tilt")));
  EXPECT_NEAR(tilt.soft_rad.min, Radians(-88), 1e-9);
  EXPECT_NEAR(tilt.hard_rad.min, Radians(-91.5), 1e-9);
  EXPECT_EQ(ers220.sensors.at(0).min, -1596976);
  for (const Sensor& sensor : Ers210().sensors) {
    if (sensor.kind != SensorKind::kForce) continue;
    EXPECT_EQ(sensor.max, 980665) << sensor.name;
  }
}

TEST(RobotModelTest, LeftAndRightAreMirrorImages) {
  for (const JointModel& left : Ers210().joints) {
    if (left.name[0] != 'L') continue;
    const JointModel& right = Ers210().joints[Ers210().FindJoint("R" + left.name.substr(1))];
    EXPECT_EQ(left.anchor_m.y(), -right.anchor_m.y()) << left.name;
    EXPECT_EQ(left.hard_rad.max, right.hard_rad.max);
    EXPECT_EQ(left.gains, right.gains);
  }
}

TEST(RobotModelTest, MotionFilesIndexFifteenJointsOfTheErs210) {
  std::vector<bool> seen(15, false);
  for (const JointModel& joint : Ers210().joints) {
    if (joint.mtn >= 0) seen.at(joint.mtn) = true;
  }
  EXPECT_EQ(seen, std::vector<bool>(15, true));
}

TEST(RobotModelTest, UnknownPostureNamesTheKnownOnes) {
  const std::string error = ErrorOf([] { Ers210().PostureAngles("handstand"); });
  EXPECT_THAT(error, testing::HasSubstr("ERS-210: no posture 'handstand'; the model has stand, "));
}

TEST(RobotModelTest, MissingFileIsNamed) {
  EXPECT_EQ(ErrorOf([] { LoadRobotModel("no/such.json"); }),
            "no/such.json: No such file or directory");
}

TEST(RobotModelTest, BrokenJsonIsNamedWithLineAndColumn) {
  EXPECT_EQ(ErrorOf([] { ParseRobotModel("{\n  \"schema\": ,\n}", "m.json"); }),
            "m.json:2:13: not valid JSON here");
}

TEST(RobotModelTest, OtherSchemaIsRefused) {
  EXPECT_EQ(ErrorWith("robot model 1", "robot model 2"),
            "m.json: schema: is 'openr-host robot model 2', this program reads "
            "'openr-host robot model 1'");
}

TEST(RobotModelTest, BoxWithoutVolumeIsRefused) {
  EXPECT_EQ(ErrorWith("[183.6, 80, 100]", "[183.6, 0, 100]"),
            "m.json: bodies.rows[0].size: 'body': edges must be > 0");
}

TEST(RobotModelTest, NegativeMassIsRefused) {
  EXPECT_EQ(ErrorWith("\"mass\": 603", "\"mass\": -603"),
            "m.json: bodies.rows[0]: 'body' has mass -603 g, must be >= 0");
}

TEST(RobotModelTest, CrossedLimitsAreRefused) {
  EXPECT_EQ(ErrorWith("\"hard\": [-85, 46]", "\"hard\": [46, -85]"),
            "m.json: joints.rows[0].hard: runs from 46 to -85, must rise");
}

TEST(RobotModelTest, SoftwareLimitsBeyondTheStopsAreRefused) {
  EXPECT_EQ(ErrorWith("\"soft\": [-82, 43]", "\"soft\": [-89, 43]"),
            "m.json: joints.rows[0].soft: must lie inside 'hard'");
}

TEST(RobotModelTest, UnknownParentIsNamed) {
  EXPECT_EQ(ErrorWith("\"parent\": \"neck_pan\"", "\"parent\": \"neck\""),
            "m.json: joints.rows[2].parent: no body 'neck'");
}

TEST(RobotModelTest, BodyWithoutJointIsNamed) {
  EXPECT_EQ(ErrorWith("   {\"name\": \"mouth\", \"mass\"",
                      "   {\"name\": \"wing\", \"mass\": 1},\n   {\"name\": \"mouth\", \"mass\""),
            "m.json: body 'wing' hangs on no joint");
}

TEST(RobotModelTest, MisspeltFieldIsRefused) {
  EXPECT_THAT(ErrorWith("\"torque\": 0.5", "\"torqe\": 0.5"),
              testing::StartsWith("m.json: joints.rows[0]: 'torqe' is unknown; known here: "));
}

TEST(RobotModelTest, SlantedAxisIsRefused) {
  EXPECT_EQ(ErrorWith("\"axis\": [0, -1, 0]", "\"axis\": [0, -1, 0.1]"),
            "m.json: joints.rows[0].axis: must be one of the axes of B, as [0, -1, 0]");
}

TEST(RobotModelTest, JointThatDisagreesWithTheSensorListIsRefused) {
  EXPECT_EQ(ErrorWith("\"sensor\": 6", "\"sensor\": 7"),
            "m.json: sensors.rows[6]: joint 'mouth' says it is sensor 7, the list says 6");
}

TEST(RobotModelTest, JointWithoutASensorIsRefused) {
  EXPECT_EQ(ErrorWith("\"kind\": \"joint\"", "\"kind\": \"raw\""),
            "m.json: joints.rows[0].sensor: is 0, but sensor 0 of the list does not measure "
            "'neck_tilt'");
}

TEST(RobotModelTest, PostureBeyondAStopIsRefused) {
  EXPECT_EQ(ErrorWith("\"degrees\": [0, 0, 0, -3, -10, 0, 30, 0,",
                      "\"degrees\": [0, 0, 0, -3, -10, 0, 180, 0,"),
            "m.json: postures.rows[0].degrees: posture 'stand' asks LF_j3 for 180 degrees, its "
            "stops are at -30 and 150");
}

TEST(RobotModelTest, PostureOfTheWrongLengthIsRefused) {
  EXPECT_EQ(ErrorWith("\"degrees\": [0, 0, 0, -3, -10,", "\"degrees\": [0, 0, -3, -10,"),
            "m.json: postures.rows[0].degrees: must have 18 numbers, has 17");
}

TEST(RobotModelTest, RangeBeyond32BitsIsRefused) {
  EXPECT_EQ(ErrorWith("\"range\": [0, 980665]", "\"range\": [0, 2147483648]"),
            "m.json: sensors.rows[3].range[1]: is 2147483648, must be -2147483648 to 2147483647");
}

TEST(RobotModelTest, RangeBeyond64BitsIsRefused) {
  EXPECT_EQ(ErrorWith("\"range\": [0, 980665]", "\"range\": [0, 18446744073709551615]"),
            "m.json: sensors.rows[3].range[1]: is 18446744073709551615, must be -2147483648 to "
            "2147483647");
}

TEST(RobotModelTest, StopsBeyondATurnAreRefused) {
  EXPECT_EQ(ErrorWith("\"hard\": [-85, 46]", "\"hard\": [-85, 361]"),
            "m.json: joints.rows[0].hard: must lie between -360 and 360 degrees");
}

TEST(RobotModelTest, CameraBeyondItsLimitsIsRefused) {
  EXPECT_EQ(ErrorWith("\"fps\": 25", "\"fps\": 126"),
            "m.json: camera.fps: is 126, must be at most 125 (one in 8 ms)");
  EXPECT_EQ(ErrorWith("\"pixels\": [352, 288]", "\"pixels\": [352, 2147483648]"),
            "m.json: camera.pixels[1]: is 2147483648, must be 1 to 4096");
  EXPECT_EQ(ErrorWith("\"pixels\": [352, 288]", "\"pixels\": [352]"),
            "m.json: camera.pixels: must be [width, height]");
  EXPECT_EQ(ErrorWith("\"pixels\": [352, 288]", "\"pixels\": [56, 288]"),
            "m.json: camera.pixels: 56 wide, must be 64 or more");
  EXPECT_EQ(ErrorWith("[44, 36]]", "[44, 36], [22, 18]]"),
            "m.json: camera.layers: has 4 layers, at most 3");
}

TEST(RobotModelTest, NumbersThatNoRobotHasAreRefused) {
  const std::string speed = "\"speed\": [2.5, 120.625]", fov = "\"fov\": [57.6, 47.8]";
  const std::string radius = "\"radius\": 12.4", lookup = "[500, 500, 0.1]";
  EXPECT_EQ(ErrorWith(speed, "\"speed\": [2.5, 100001]"),
            "m.json: joints.rows[0].speed[1]: is 100001, must be > 0 and at most 100000");
  EXPECT_EQ(ErrorWith(speed, "\"speed\": [0, 120]"), "m.json: joints.rows[0].speed: must be > 0");
  EXPECT_EQ(ErrorWith("\"max\": 312.5", "\"max\": 1000001"),
            "m.json: acceleration.max: is 1000001, must be > 0 and at most 1000000");
  EXPECT_EQ(ErrorWith("\"max\": 312.5", "\"max\": 0"),
            "m.json: acceleration.max: is 0, must be > 0 and at most 1000000");
  EXPECT_EQ(ErrorWith("\"max\": 312.5", "\"max\": 1"),
            "m.json: acceleration: min, default and max must not fall");
  EXPECT_EQ(ErrorWith(fov, "\"fov\": [57.6, 180]"), "m.json: camera.fov[1]: is 180, must be < 180");
  EXPECT_EQ(ErrorWith(fov, "\"fov\": [0, 47.8]"), "m.json: camera.fov[0]: is 0, must be > 0");
  EXPECT_EQ(ErrorWith(radius, "\"radius\": 1001"),
            "m.json: paws.rows[0].radius: is 1001, must be > 0 and at most 1000");
  EXPECT_EQ(ErrorWith(lookup, "[500, 100001, 0.1]"),
            "m.json: sensors.rows[5].lookup[2][1]: is 100001, must be 0 to 100000");
  EXPECT_EQ(ErrorWith(lookup, "[-500, 500, 0.1]"),
            "m.json: sensors.rows[5].lookup[2][0]: is -500, must be 0 to 100000");
  EXPECT_EQ(ErrorWith(lookup, "[500, 500, 1.5]"),
            "m.json: sensors.rows[5].lookup[2][2]: is 1.5, must be 0 to 1");
}

TEST(RobotModelTest, LastNumbersWithinTheLimitsAreAccepted) {
  const std::vector<Changes> accepted = {
      {{"\"fps\": 25", "\"fps\": 125"}},
      {{"\"hard\": [-85, 46]", "\"hard\": [-360, 360]"}},
      {{"\"range\": [0, 980665]", "\"range\": [-2147483648, 2147483647]"}},
      {{"\"speed\": [2.5, 120.625]", "\"speed\": [2.5, 100000]"}},
      {{"\"max\": 312.5", "\"max\": 1000000"}},
      {{"\"fov\": [57.6, 47.8]", "\"fov\": [179.9, 179.9]"}},
      {{"\"radius\": 12.4", "\"radius\": 1000"}},
      {{"[900, 900, 0]", "[100000, 100000, 1]"}},
      {{"\"pixels\": [352, 288]", "\"pixels\": [64, 8]"},
       {"[[176, 144], [88, 72], [44, 36]]", "[[32, 4], [16, 2], [8, 1]]"}},
      {{"\"pixels\": [352, 288]", "\"pixels\": [4096, 4096]"},
       {"[[176, 144], [88, 72], [44, 36]]", "[[2048, 2048], [1024, 1024], [512, 512]]"}}};
  for (const Changes& changes : accepted)
    EXPECT_NO_THROW(ParseRobotModel(Changed(changes), "m.json")) << changes[0].second;
}

TEST(RobotModelTest, NumbersJustBeyondTheLimitsAreRefused) {
  EXPECT_NE(ErrorWith("\"hard\": [-85, 46]", "\"hard\": [-361, 46]"), "");
  EXPECT_NE(ErrorWith("\"range\": [0, 980665]", "\"range\": [-2147483649, 980665]"), "");
  EXPECT_NE(ErrorWith("\"pixels\": [352, 288]", "\"pixels\": [4104, 288]"), "");
}

TEST(RobotModelTest, ModelWithoutSleepingPostureIsRefused) {
  EXPECT_THAT(ErrorWith("{\"name\": \"sleep\"", "{\"name\": \"nap\""),
              testing::StartsWith("m.json: postures: 'sleep' is missing"));
}

}  // namespace
}  // namespace openr_host
