// Joints commanded by a plain DDS participant.
#include <cmath>

#include "openr/ros2/ros2_link.h"
#include "tests/distribution/ros2/ros2_run.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

constexpr const char* kTopic = "rt/aibo/joint_command";

size_t OccurrencesOf(const std::string& part, const std::string& text) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// Waits for the joint to reach `position_rad`; returns its last position.
double WaitForJoint(const Ros2Run& run, const std::string& robot, const std::string& joint,
                    double position_rad) {
  double position = 0;
  for (int i = 0; i < 40; ++i) {
    position = run.peer().Position(robot, joint);
    if (std::abs(position - position_rad) < 0.03) break;
  }
  return position;
}

TEST(Ros2CommandsTest, JointsGoWhereTheyAreToldAndAReplayIsEqual) {
  const ScratchFolder folder;
  Ros2Run run({"--record", folder.File("r")});
  run.WaitForStanding();
  EXPECT_NEAR(run.peer().Position("aibo", "neck_pan"), 0, 0.02);
  run.peer().Do({"command", kTopic, "neck_pan=0.5@2", "tail_tilt=0.2@0"});
  EXPECT_NEAR(WaitForJoint(run, "aibo", "neck_pan", 0.5), 0.5, 0.03);
  EXPECT_NEAR(WaitForJoint(run, "aibo", "tail_tilt", 0.2), 0.2, 0.03);
  run.peer().Do({"command", kTopic, "neck_pan=-0.4"});
  EXPECT_NEAR(WaitForJoint(run, "aibo", "neck_pan", -0.4), -0.4, 0.03);
  run.End();
  const ProgramResult replay = RunProgram({"replay", folder.File("r")});
  EXPECT_EQ(replay.status, 0) << replay.err;
  EXPECT_THAT(replay.out + replay.err, HasSubstr("to the end of the recording"));
}

TEST(Ros2CommandsTest, LimitsOfTheRobotHold) {
  const RobotModel model = LoadRobotModel(OPENR_MODEL_DIR "/ers210.json");
  const JointModel& pan = model.joints[static_cast<size_t>(model.FindJoint("neck_pan"))];
  const Ros2Run run({});
  run.WaitForStanding();
  run.peer().Do({"command", kTopic, "neck_pan=1e300@1e300"});
  EXPECT_NEAR(WaitForJoint(run, "aibo", "neck_pan", pan.soft_rad.max), pan.soft_rad.max, 0.03);
}

TEST(Ros2CommandsTest, AnInvalidCommandIsRefusedOnceByName) {
  Ros2Run run({});
  run.WaitForStanding();
  for (int i = 0; i < 3; ++i) {
    run.peer().Do({"command", kTopic, "neck_pan=0.5", "nose=1"});
    run.peer().Do({"command", kTopic, "neck_pan=nan"});
    run.peer().Do({"command", kTopic, "neck_pan"});
  }
  ASSERT_TRUE(run.program().WaitFor("1 names, 0 positions, 0 velocities"));
  // An invalid command moves no joint, nor the valid ones in it.
  EXPECT_NEAR(run.peer().Position("aibo", "neck_pan"), 0, 0.02);
  const ProgramResult& result = run.End();
  EXPECT_EQ(OccurrencesOf("'nose' is no joint of the ERS-210; there are neck_tilt, ", result.err),
            1u);
  EXPECT_EQ(OccurrencesOf("the position of neck_pan is no number", result.err), 1u);
  EXPECT_EQ(OccurrencesOf("1 names, 0 positions", result.err), 1u);
}

TEST(Ros2CommandsTest, AfterTwentyProblemsTheRestIsCounted) {
  Ros2Run run({});
  for (int i = 0; i < 25; ++i) run.peer().Do({"command", kTopic, "j" + std::to_string(i) + "=0"});
  ASSERT_TRUE(run.program().WaitFor("ROS 2: no more of this is said of /aibo"));
  const ProgramResult& result = run.End();
  EXPECT_EQ(OccurrencesOf("is no joint of", result.err), 20u);
  EXPECT_THAT(result.err, HasSubstr("ROS 2: /aibo: 5 more problems were not said"));
}

TEST(Ros2ProblemsTest, EachOnceAndTheRestIsCounted) {
  std::vector<std::string> said;
  Ros2Problems problems("aibo", [&](const std::string& line) { said.push_back(line); });
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 23; ++i) problems.Add("text " + std::to_string(i));
  }
  ASSERT_EQ(said.size(), 21u);
  EXPECT_EQ(said[0], "ROS 2: text 0 (said once)");
  EXPECT_EQ(said[20], "ROS 2: no more of this is said of /aibo");
  problems.PrintLeftOutCount();
  EXPECT_EQ(said.back(), "ROS 2: /aibo: 6 more problems were not said");
}

TEST(Ros2ProblemsTest, WithoutProblemsNothingIsPrinted) {
  std::vector<std::string> said;
  Ros2Problems problems("aibo", [&](const std::string& line) { said.push_back(line); });
  problems.Add("text");
  problems.PrintLeftOutCount();
  EXPECT_EQ(said.size(), 1u);
}

TEST(Ros2CommandsTest, OneRobotsProblemsDoNotSilenceAnothers) {
  Ros2Run run({"--robots", "2", "--body", "ideal"});
  for (int i = 0; i < 21; ++i)
    run.peer().Do({"command", "rt/aibo0/joint_command", "j" + std::to_string(i) + "=0"});
  ASSERT_TRUE(run.program().WaitFor("ROS 2: no more of this is said of /aibo0"));
  run.peer().Do({"command", "rt/aibo1/joint_command", "nose=0"});
  EXPECT_TRUE(run.program().WaitFor("aibo1/joint_command: refused: 'nose' is no joint"));
}

TEST(Ros2CommandsTest, TheRobotsOwnRefusalIsHeard) {
  Ros2Run run({}, "0.5");
  run.peer().Do({"command", kTopic, "neck_pan=0.5"});
  EXPECT_TRUE(run.program().WaitFor("the robot refuses: the robot is still on its way"));
}

TEST(Ros2CommandsTest, APublisherThatDoesNotMatchIsNamed) {
  Ros2Run run({});
  const ProgramRun publisher({run.domain(), "offer", kTopic}, ROS2_PEER);
  EXPECT_TRUE(run.program().WaitFor("aibo/joint_command: a publisher does not match"));
}

TEST(Ros2CommandsTest, TheRemoteControlMayBeInAnotherProcess) {
  const ScratchFolder folder;
  Ros2Run run({"--record", folder.File("r"), "--isolate", "RCServer"});
  run.WaitForStanding();
  run.peer().Do({"command", kTopic, "neck_pan=0.5"});
  EXPECT_NEAR(WaitForJoint(run, "aibo", "neck_pan", 0.5), 0.5, 0.03);
  run.End();
  EXPECT_EQ(RunProgram({"replay", folder.File("r")}).status, 0);
}

TEST(Ros2CommandsTest, AMissingRemoteControlIsReported) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  Ros2Run run({"--stick", stick.path()});
  run.peer().Do({"command", kTopic, "neck_pan=0.5"});
  EXPECT_TRUE(run.program().WaitFor("is RCServer on the stick"));
}

TEST(Ros2CommandsTest, ACommandIsForOneOfSeveralRobots) {
  const Ros2Run run({"--robots", "2", "--body", "ideal"});
  run.WaitForStanding();
  run.peer().Do({"command", "rt/aibo1/joint_command", "neck_pan=0.5"});
  EXPECT_NEAR(WaitForJoint(run, "aibo1", "neck_pan", 0.5), 0.5, 0.03);
  EXPECT_NEAR(run.peer().Position("aibo0", "neck_pan"), 0, 0.02);
}

}  // namespace
}  // namespace openr_host
