// The topics of a run, as a plain DDS participant receives them.
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "tests/distribution/ros2/ros2_run.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

RobotModel Model() { return LoadRobotModel(OPENR_MODEL_DIR "/ers210.json"); }

TEST(Ros2TopicsTest, TopicsAndTypesAreNamedAsRos2HasThem) {
  const Ros2Run run({});
  std::map<std::string, json> topics;
  for (const json& topic : run.peer().Do({"topics"})) {
    topics[topic["topic"]] = topic;
    EXPECT_EQ(topic["reliable"], true) << topic;
    const std::set<std::string> kept = {"rt/aibo/robot_description", "rt/aibo/audio_info"};
    EXPECT_EQ(topic["volatile"], !kept.contains(topic["topic"])) << topic;
    EXPECT_EQ(topic["plain_cdr"], true) << topic;
    EXPECT_EQ(topic["partition"], "") << topic;
  }
  const auto type = [&](const std::string& name) { return topics["rt/" + name]["type"]; };
  EXPECT_EQ(type("clock"), "rosgraph_msgs::msg::dds_::Clock_");
  EXPECT_EQ(type("aibo/joint_states"), "sensor_msgs::msg::dds_::JointState_");
  EXPECT_EQ(type("aibo/imu"), "sensor_msgs::msg::dds_::Imu_");
  EXPECT_EQ(type("aibo/image_raw"), "sensor_msgs::msg::dds_::Image_");
  EXPECT_EQ(type("aibo/touch/chin_switch"), "std_msgs::msg::dds_::Bool_");
  EXPECT_EQ(type("aibo/touch/head_sensor_front"), "std_msgs::msg::dds_::Float32_");
  EXPECT_EQ(type("aibo/distance/distance_sensor_psd"), "std_msgs::msg::dds_::Float32_");
  EXPECT_EQ(type("aibo/temperature/thermo_sensor"), "sensor_msgs::msg::dds_::Temperature_");
  EXPECT_EQ(type("aibo/odom"), "nav_msgs::msg::dds_::Odometry_");
  EXPECT_EQ(type("tf"), "tf2_msgs::msg::dds_::TFMessage_");
  EXPECT_EQ(type("aibo/battery"), "sensor_msgs::msg::dds_::BatteryState_");
  EXPECT_EQ(type("diagnostics"), "diagnostic_msgs::msg::dds_::DiagnosticArray_");
  EXPECT_EQ(type("aibo/joint_command"), "sensor_msgs::msg::dds_::JointState_");
  EXPECT_EQ(topics["rt/aibo/joint_command"]["kind"], "reader");
  EXPECT_EQ(topics["rt/aibo/joint_states"]["kind"], "writer");
}

TEST(Ros2TopicsTest, TheTopicsShowAStandingDog) {
  const Ros2Run run({});
  run.WaitForStanding();
  const RobotModel model = Model();
  const json joints = run.peer().ReadOne("sensor_msgs/JointState", "rt/aibo/joint_states");
  ASSERT_EQ(joints["name"].size(), model.joints.size());
  EXPECT_EQ(joints["velocity"].size(), model.joints.size());
  EXPECT_EQ(joints["effort"].size(), 0u);
  EXPECT_EQ(joints["frame_id"], "");
  for (size_t i = 0; i < model.joints.size(); ++i) {
    EXPECT_EQ(joints["name"][i], model.joints[i].name);
    if (model.joints[i].name == "tail_pan") continue;  // its controller wags the tail
    EXPECT_NEAR(joints["position"][i], model.PostureAngles("stand")[i], 0.05) << joints["name"][i];
  }
  const json imu = run.peer().ReadOne("sensor_msgs/Imu", "rt/aibo/imu");
  EXPECT_EQ(imu["frame_id"], "aibo/base_link");
  EXPECT_NEAR(imu["acceleration"][2], 9.8, 0.1);
  EXPECT_NEAR(imu["acceleration"][1], 0, 0.1);
  // The dog stands with its nose 2.6 degrees down, so the force against gravity points a little
  // backwards.
  EXPECT_NEAR(imu["acceleration"][0], -9.8 * std::sin(2.6 * 3.14159265 / 180), 0.1);
  EXPECT_EQ(imu["orientation_covariance"][0], -1);
  EXPECT_EQ(imu["angular_velocity_covariance"][0], -1);
  for (const char* paw : {"left_fore", "left_hind", "right_fore", "right_hind"}) {
    const std::string topic = std::string("rt/aibo/touch/paw_sensor_") + paw + "_leg";
    EXPECT_EQ(run.peer().ReadOne("std_msgs/Bool", topic), true) << paw;
  }
  EXPECT_EQ(run.peer().ReadOne("std_msgs/Bool", "rt/aibo/touch/back_sensor"), false);
  const json far = run.peer().ReadOne("std_msgs/Float32", "rt/aibo/distance/distance_sensor_psd");
  EXPECT_NEAR(far[0], 0.9, 0.09);  // nothing is in front of the sensor
}

TEST(Ros2TopicsTest, TheCameraShowsItsPictureAtItsRate) {
  const Ros2Run run({"--images", "pattern"}, "1");
  const std::vector<json> images = run.peer().Read("sensor_msgs/Image", "rt/aibo/image_raw", 5);
  ASSERT_EQ(images.size(), 5u);
  int64_t before_us = 0;
  for (const json& image : images) {
    EXPECT_EQ(image["width"], 352);
    EXPECT_EQ(image["height"], 288);
    EXPECT_EQ(image["step"], 3 * 352);
    EXPECT_EQ(image["bytes"], 3 * 352 * 288);
    EXPECT_EQ(image["encoding"], "rgb8");
    EXPECT_EQ(image["frame_id"], "aibo/camera_optical");
    EXPECT_GT(image["colours"], 200);  // colour bars and a wedge of greys
    const int64_t stamp_us = image["stamp_us"];
    EXPECT_GT(stamp_us, before_us);
    EXPECT_EQ(stamp_us % 40'000, 0) << "25 a second of virtual time";
    before_us = stamp_us;
  }
}

// The picture is red, green over blue, yellow, so that swapped sides or colours show.
TEST(Ros2TopicsTest, AnImageIsAsTheCameraSeesIt) {
  const std::string colours[2][2] = {{{'\xb4', '\x3c', '\x32'}, {'\x3c', '\xb4', '\x32'}},
                                     {{'\x3c', '\x32', '\xb4'}, {'\xc8', '\xc8', '\x28'}}};
  std::string pixels;
  for (int y = 0; y < 288; ++y) {
    for (int x = 0; x < 352; ++x) pixels += colours[y >= 144][x >= 176];
  }
  const ScratchFolder folder;
  folder.Write("images/a.ppm", "P6 352 288 255\n" + pixels);
  const Ros2Run run({"--images", folder.File("images")}, "1");
  EXPECT_EQ(run.peer().ReadOne("sensor_msgs/Image", "rt/aibo/image_raw")["quarters"],
            json::parse("[[180,60,50],[60,180,50],[60,50,180],[200,200,40]]"));
}

TEST(Ros2TopicsTest, TheClockGoesByFramesForReadersOfBothKinds) {
  const Ros2Run run({}, "1");
  for (const char* kind : {"reliable", "best"}) {
    SCOPED_TRACE(kind);
    const std::vector<json> ticks =
        run.peer().Do({"read", "rosgraph_msgs/Clock", "rt/clock", "20", kind});
    ASSERT_EQ(ticks.size(), 20u);
    int64_t before_us = 0;
    for (const json& tick : ticks) {
      const int64_t stamp_us = tick["stamp_us"];
      EXPECT_GT(stamp_us, before_us);
      EXPECT_EQ(stamp_us % 8000, 0);
      before_us = stamp_us;
    }
  }
}

TEST(Ros2TopicsTest, StampsOfAllTopicsAreOfOneClock) {
  const Ros2Run run({}, "1");
  const int64_t before_us = run.peer().ReadOne("rosgraph_msgs/Clock", "rt/clock")["stamp_us"];
  const int64_t joints_us =
      run.peer().ReadOne("sensor_msgs/JointState", "rt/aibo/joint_states")["stamp_us"];
  const int64_t after_us = run.peer().ReadOne("rosgraph_msgs/Clock", "rt/clock")["stamp_us"];
  EXPECT_LT(before_us, joints_us);
  EXPECT_LT(joints_us, after_us);
}

// A run of some seconds that several programs listen to.
class Ros2ListenedToTest : public testing::Test {
 protected:
  static constexpr const char* kTime = "4s";

  static void SetUpTestSuite() { alone = std::make_unique<RecordedRun>(Record({"--for", kTime})); }
  static void TearDownTestSuite() { alone.reset(); }

  void Listen(const std::string& type, const std::string& topic) {
    listeners_.push_back(
        std::make_unique<ProgramRun>(Words{domain_, "read", type, topic, "3"}, ROS2_PEER));
  }
  // The listeners start first: on a slow machine they would start after the end of the run.
  void ExpectTheSameRun(const Words& flags) {
    const ScratchFolder folder;
    const ProgramResult result =
        RunProgram(Words{"run", "--rate", "1", "--no-panel", "--rc-port", "0", "--json", "--record",
                         folder.File("r"), "--for", kTime, "--ros2", "--dds-domain", domain_} +
                   flags);
    for (const auto& listener : listeners_) {
      const ProgramResult& heard = listener->Finish();
      EXPECT_EQ(heard.status, 0) << heard.err;
      EXPECT_EQ(std::count(heard.out.begin(), heard.out.end(), '\n'), 3) << heard.out;
    }
    ExpectSame(*alone, {result.status, result.err, folder.Read("r"),
                        json::parse(result.out, nullptr, false)});
  }

  static inline std::unique_ptr<RecordedRun> alone;
  const std::string domain_ = NewDomain();
  const Ros2Peer peer_{domain_};  // sets the environment of the listeners
  std::vector<std::unique_ptr<ProgramRun>> listeners_;
};

TEST_F(Ros2ListenedToTest, ListeningChangesNothing) {
  Listen("sensor_msgs/Image", "rt/aibo/image_raw");
  Listen("sensor_msgs/JointState", "rt/aibo/joint_states");
  ExpectTheSameRun({});
}

TEST_F(Ros2ListenedToTest, TheBusOfARunInSeveralProcessesIsShared) {
  Listen("sensor_msgs/Imu", "rt/aibo/imu");
  ExpectTheSameRun({"--isolate", "RCServer"});
}

TEST(Ros2TopicsTest, AReaderThatStopsStopsNeitherTheRunNorOtherReaders) {
  const std::string domain = NewDomain();
  const Ros2Peer peer(domain);
  ProgramRun run({"run", "--rate", "2", "--no-panel", "--rc-port", "0", "--console", "/dev/null",
                  "--ros2", "--dds-domain", domain});
  // The stopped reader must not be taken for lost.
  std::string settings = DocumentedSettings();
  const std::string discovery = "<Discovery>";
  settings.insert(settings.find(discovery) + discovery.size(),
                  "<LeaseDuration>3600s</LeaseDuration>");
  setenv("CYCLONEDDS_URI", settings.c_str(), 1);
  ProgramRun reader({domain, "read", "sensor_msgs/Image", "rt/aibo/image_raw", "100000"},
                    ROS2_PEER);
  ASSERT_TRUE(reader.WaitForOutput("rgb8"));
  reader.Signal(SIGSTOP);
  EXPECT_EQ(peer.Read("sensor_msgs/Image", "rt/aibo/image_raw", 20).size(), 20u);
  EXPECT_EQ(peer.Read("rosgraph_msgs/Clock", "rt/clock", 200).size(), 200u);
  run.Signal(SIGINT);
  const ProgramResult& result = run.Finish();  // ends the run if it hangs
  EXPECT_EQ(result.status, 0) << result.err;
  reader.Signal(SIGKILL);
}

TEST(Ros2TopicsTest, AMonitoredRunHasOneBus) {
  const Ros2Run run({"--monitor"});
  EXPECT_EQ(run.peer().Read("rosgraph_msgs/Clock", "rt/clock", 1).size(), 1u);
}

TEST(Ros2TopicsTest, SeveralRobotsAreNumbered) {
  const Ros2Run run({"--robots", "2", "--ros2-namespace", "team/rex", "--body", "ideal"});
  const json first = run.peer().ReadOne("sensor_msgs/Imu", "rt/team/rex0/imu");
  const json second = run.peer().ReadOne("sensor_msgs/Imu", "rt/team/rex1/imu");
  EXPECT_EQ(first["frame_id"], "team/rex0/base_link");
  EXPECT_EQ(second["frame_id"], "team/rex1/base_link");
}

TEST(Ros2TopicsTest, ANamespaceIsOneOfRos2) {
  for (const char* name : {"", "4legs", "a dog", "dog/", "/dog", "dog//tail", "d\xc3\xb6g"}) {
    const ProgramResult result = RunProgram({"run", "--ros2", "--ros2-namespace", name});
    EXPECT_EQ(result.status, 2) << name;
    EXPECT_THAT(result.err, HasSubstr("is no namespace of ROS 2")) << name;
  }
  EXPECT_EQ(RunProgram({"run", "--ros2-namespace", "rex", "--for", "1s"}).status, 2);
}

TEST(Ros2TopicsTest, AnotherRobotTellsItsOwnSensors) {
  const Ros2Run run({"--robot", "ers7", "--body", "ideal"});
  std::vector<std::string> touch;
  for (const json& topic : run.peer().Do({"topics"})) {
    const std::string name = topic["topic"];
    if (name.starts_with("rt/aibo/distance/")) touch.push_back(name.substr(17));
  }
  EXPECT_THAT(touch, ElementsAre("chest_distance_sensor", "head_distance_sensor_far",
                                 "head_distance_sensor_near"));
}

}  // namespace
}  // namespace openr_host
