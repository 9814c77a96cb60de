// The topics of a run that are not sensors: odometry, battery, lights, sound, diagnostics and the
// description of the robot, as a plain DDS participant receives them.
#include <cmath>
#include <fstream>

#include "tests/distribution/ros2/ros2_run.h"
#include "tests/distribution/sticks.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

RobotModel TheModel() { return LoadRobotModel(OPENR_MODEL_DIR "/ers210.json"); }

TEST(Ros2StateTopicsTest, OdometryAndTransformSayWhereTheDogStands) {
  const Ros2Run run({});
  run.WaitForStanding();
  const json odometry = run.peer().ReadOne("nav_msgs/Odometry", "rt/aibo/odom");
  EXPECT_EQ(odometry["frame_id"], "aibo/odom");
  EXPECT_EQ(odometry["child"], "aibo/base_link");
  const std::vector<double> turn = odometry["orientation"];
  EXPECT_NEAR(std::hypot(std::hypot(turn[0], turn[1]), std::hypot(turn[2], turn[3])), 1, 1e-6);
  // The nose of the standing dog points 2.6 degrees down: a turn about y to the left.
  EXPECT_NEAR(2 * std::asin(turn[1]) * 180 / 3.14159265, 2.6, 1.0);
  EXPECT_GT(odometry["position"][2], 0.10);
  EXPECT_LT(odometry["position"][2], 0.20);
  EXPECT_NEAR(odometry["linear"][0], 0, 0.05);
  const json transform = run.peer().ReadOne("tf2_msgs/TFMessage", "rt/tf")[0];
  EXPECT_EQ(transform["frame_id"], "aibo/odom");
  EXPECT_EQ(transform["child"], "aibo/base_link");
  EXPECT_NEAR(transform["translation"][2], odometry["position"][2], 0.005);
  EXPECT_NEAR(transform["rotation"][1], turn[1], 0.01);
}

TEST(Ros2StateTopicsTest, TheBatteryHasTheUnitsOfRos2) {
  const Ros2Run run({"--battery", "80%"});
  const json battery = run.peer().ReadOne("sensor_msgs/BatteryState", "rt/aibo/battery");
  const std::vector<double> values = battery["values"];
  EXPECT_GT(values[0], 5) << "V";
  EXPECT_LT(values[0], 10) << "V";
  EXPECT_LT(values[1], 0) << "A, discharged";
  EXPECT_GT(values[2], 10) << "degrees Celsius";
  EXPECT_LT(values[2], 50) << "degrees Celsius";
  EXPECT_GT(values[3], 0.5) << "A h";
  EXPECT_NEAR(values[4], 0.8, 1e-6);
  EXPECT_EQ(battery["status"], 2) << "discharging";
  EXPECT_EQ(battery["present"], true);
}

TEST(Ros2StateTopicsTest, TheTemperatureIsThatOfTheSensorInDegreesCelsius) {
  const ScratchFolder folder;
  folder.Write("heat.events", "1s heat body 41\n");
  const Ros2Run run({"--events", folder.File("heat.events")});
  run.WaitUntil(3'000'000);
  const json temperature =
      run.peer().ReadOne("sensor_msgs/Temperature", "rt/aibo/temperature/thermo_sensor");
  EXPECT_EQ(temperature["frame_id"], "aibo/base_link");
  EXPECT_GE(temperature["stamp_us"], 3'000'000);
  EXPECT_EQ(temperature["values"], json::parse("[41,0]")) << "degrees Celsius, variance not known";
}

// The tone of examples/Tone begins at the boot and lasts a second.  The run is slow, so that the
// reader comes before its end.
TEST(Ros2StateTopicsTest, AReaderHearsWhatTheSpeakerPlays) {
  const ScratchFolder stick;
  MakeStick(stick, {"TONE.BIN"},
            "Tone.Speaker.OSoundVectorData.S "
            "OVirtualRobotAudioComm.Speaker.OSoundVectorData.O\n");
  const Ros2Run run({"--stick", stick.path()}, "0.1");
  const std::vector<json> sounds =
      run.peer().Read("audio_common_msgs/AudioData", "rt/aibo/audio", 3);
  ASSERT_EQ(sounds.size(), 3u);
  for (const json& sound : sounds) {
    EXPECT_EQ(sound["bytes"], 256) << "a frame of 8 ms, 16,000 samples of 16 bits a second";
    EXPECT_EQ(sound["loudest"], 8000) << "the amplitude of the tone";
  }
}

TEST(Ros2StateTopicsTest, EveryLightOfTheModelHasATopic) {
  const Ros2Run run({});
  const RobotModel model = TheModel();
  int lights = 0;
  for (const json& topic : run.peer().Do({"topics"}))
    lights += topic["topic"].get<std::string>().starts_with("rt/aibo/led/");
  EXPECT_EQ(lights, static_cast<int>(model.leds.size()));
}

TEST(Ros2StateTopicsTest, LateReadersGetTheDescriptionOfTheRobot) {
  const Ros2Run run({});
  run.WaitUntil(1'000'000);
  const std::vector<json> texts =
      run.peer().Do({"read", "std_msgs/String", "rt/aibo/robot_description", "1", "late"});
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_THAT(texts[0].get<std::string>(), HasSubstr("<robot name=\"ERS-210\">"));
  EXPECT_THAT(texts[0].get<std::string>(), HasSubstr("<link name=\"base_link\"/>"));
  const std::vector<json> infos =
      run.peer().Do({"read", "audio_common_msgs/AudioInfo", "rt/aibo/audio_info", "1", "late"});
  ASSERT_EQ(infos.size(), 1u);
  EXPECT_EQ(infos[0]["rate"], 16000);
  EXPECT_EQ(infos[0]["channels"], 1);
}

TEST(Ros2StateTopicsTest, DiagnosticsTellFaultsOfTheBody) {
  const ScratchFolder folder;
  folder.Write("break.events", "1s break LF_j1 weak 30%\n");
  const Ros2Run run({"--events", folder.File("break.events")});
  run.WaitUntil(3'000'000);
  const json all = run.peer().ReadOne("diagnostic_msgs/DiagnosticArray", "rt/diagnostics");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0]["name"], "aibo: battery");
  EXPECT_EQ(all[0]["level"], 0);
  EXPECT_EQ(all[1]["name"], "aibo: body");
  EXPECT_EQ(all[1]["level"], 1);
  EXPECT_EQ(all[1]["values"], 1);
  EXPECT_EQ(all[2]["name"], "aibo: objects");
  EXPECT_EQ(all[2]["hardware"], "aibo");
}

TEST(Ros2StateTopicsTest, ANoteIsNoWarningOfTheDiagnostics) {
  const ScratchFolder folder;
  std::filesystem::copy(OPENR_STICK, folder.File("stick"),
                        std::filesystem::copy_options::recursive);
  std::filesystem::remove(folder.File("stick/OPEN-R/MW/CONF/CONNECT.CFG"));
  const Ros2Run run({"--stick", folder.File("stick")});
  const json all = run.peer().ReadOne("diagnostic_msgs/DiagnosticArray", "rt/diagnostics");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_THAT(all[2]["message"].get<std::string>(), HasSubstr("CONNECT.CFG"));
  EXPECT_EQ(all[2]["level"], 0);
}

}  // namespace
}  // namespace openr_host
