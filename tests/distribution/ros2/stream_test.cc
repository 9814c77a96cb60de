// Streams of joint commands, and the loss of the worker with the remote control during a stream.
#include <signal.h>

#include <cmath>

#include "RemoteProtocol.h"
#include "tests/distribution/kill_process.h"
#include "tests/distribution/ros2/ros2_run.h"
#include "tests/distribution/wait_until.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kCommandTopic = "rt/aibo/joint_command";

struct Move {
  int joint;
  int centideg;
};

// Returns the MOVE packets that the robot has read, from a recording.
std::vector<Move> MovesIn(const std::string& recording) {
  const std::string begin = {'R', 'C', 13, 0, RC_VERSION, rcMOVE, 0, 0};
  std::vector<Move> moves;
  for (size_t at = 0; (at = recording.find(begin, at)) != std::string::npos; at += begin.size()) {
    const auto* const bytes =
        reinterpret_cast<const unsigned char*>(recording.data() + at + begin.size());
    moves.push_back({bytes[0], static_cast<int>(bytes[1] | bytes[2] << 8 | bytes[3] << 16 |
                                                static_cast<unsigned>(bytes[4]) << 24)});
  }
  return moves;
}

// A publisher does not wait for the robot.  The newest command of each joint is used, in their
// order.
TEST(Ros2StreamTest, ManyCommandsAreReadInOrderAndAReplayIsEqual) {
  const RobotModel model = LoadRobotModel(OPENR_MODEL_DIR "/ers210.json");
  const ScratchFolder folder;
  Ros2Run run({"--record", folder.File("r")});
  run.WaitForStanding();
  const Words others = {"neck_tilt", "neck_roll", "tail_tilt", "mouth"};
  Words commands = {"commands", kCommandTopic, "0"};
  for (int i = 1; i <= 4; ++i) {
    commands.push_back("neck_pan=" + std::to_string(0.1 * i));
    commands.push_back(others[static_cast<size_t>(i - 1)] + "=-0.1");
  }
  run.peer().Do(commands);
  for (int i = 0; i < 40 && std::abs(run.peer().Position("aibo", "neck_pan") - 0.4) > 0.03; ++i) {
  }
  run.End();
  std::map<int, std::vector<int>> values;
  for (const Move& move : MovesIn(folder.Read("r"))) values[move.joint].push_back(move.centideg);
  for (const std::string& joint : others)
    EXPECT_EQ(values[model.FindJoint(joint)], std::vector<int>{-573}) << joint;
  const std::vector<int>& pan = values[model.FindJoint("neck_pan")];
  ASSERT_FALSE(pan.empty());
  EXPECT_TRUE(std::is_sorted(pan.begin(), pan.end()));
  EXPECT_EQ(pan.back(), 2292);
  const ProgramResult replay = RunProgram({"replay", folder.File("r")});
  EXPECT_EQ(replay.status, 0) << replay.err;
  EXPECT_THAT(replay.out + replay.err, HasSubstr("to the end of the recording"));
}

// ---- RCServer in a worker that is killed

class LostRemoteControlTest : public testing::Test {
 protected:
  // Sends commands without end, 200 a second.
  static Words Stream() { return {"stream", kCommandTopic, "5", "neck_pan=0.3", "neck_pan=0.35"}; }
  static void KillRemoteControl(Ros2Run* run) {
    const std::vector<pid_t> children = ChildrenOf(run->program().pid());
    ASSERT_EQ(children.size(), 1u);
    KillProcess(children[0], SIGKILL);
  }
  static void WaitUntilTheyWork(const Ros2Run& run) {
    WaitUntil("a move", [&] { return run.peer().Position("aibo", "neck_pan") > 0.1; });
  }
  static void ExpectThatJointsObey(const Ros2Run& run) {
    run.peer().Do({"command", kCommandTopic, "neck_pan=0.5"});
    double position = 0;
    for (int i = 0; i < 40 && std::abs(position - 0.5) > 0.03; ++i)
      position = run.peer().Position("aibo", "neck_pan");
    EXPECT_NEAR(position, 0.5, 0.03);
  }
};

TEST_F(LostRemoteControlTest, CommandsWorkAfterARestart) {
  Ros2Run run({"--isolate", "RCServer", "--restart", "1"});
  run.WaitForStanding();
  ProgramRun stream(Words{run.domain()} + Stream(), ROS2_PEER);
  WaitUntilTheyWork(run);
  ASSERT_NO_FATAL_FAILURE(KillRemoteControl(&run));
  ASSERT_TRUE(run.program().WaitFor("process 'RCServer' is back")) << run.program().heard();
  stream.Signal(SIGTERM);
  EXPECT_EQ(stream.Finish().status, 128 + SIGTERM) << stream.heard();
  ExpectThatJointsObey(run);
  EXPECT_EQ(run.End().status, 1);  // because of the loss
}

TEST_F(LostRemoteControlTest, ARunWithoutRemoteControlGoesOnAndReportsIt) {
  Ros2Run run({"--isolate", "RCServer", "--free-running"}, "5");
  run.WaitForStanding();
  ProgramRun stream(Words{run.domain()} + Stream(), ROS2_PEER);
  WaitUntilTheyWork(run);
  ASSERT_NO_FATAL_FAILURE(KillRemoteControl(&run));
  ASSERT_TRUE(run.program().WaitFor("process 'RCServer' (pid ")) << run.program().heard();
  ASSERT_TRUE(run.program().WaitFor(
      "aibo/joint_command: the remote control of the robot has not taken a command for 1 s"));
  stream.Signal(SIGTERM);
  EXPECT_EQ(stream.Finish().status, 128 + SIGTERM) << stream.heard();
  EXPECT_EQ(run.peer().Read("rosgraph_msgs/Clock", "rt/clock", 3).size(), 3u);
  const ProgramResult& result = run.End();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("RCServer"));
  EXPECT_THAT(result.err, Not(HasSubstr("crash")));
}

// ---- With the wall clock

TEST(Ros2FreeRunningTest, TopicsComeAndTheClockGoesOn) {
  Ros2Run run({"--place", "RCServer=net", "--free-running", "--body", "ideal"}, "1");
  int64_t before_us = 0;
  for (const json& tick : run.peer().Read("rosgraph_msgs/Clock", "rt/clock", 30)) {
    const int64_t stamp_us = tick["stamp_us"];
    EXPECT_GT(stamp_us, before_us);
    before_us = stamp_us;
  }
  const json joints = run.peer().ReadOne("sensor_msgs/JointState", "rt/aibo/joint_states");
  EXPECT_GT(joints["stamp_us"], before_us);
  EXPECT_FALSE(joints["position"].empty());
  EXPECT_EQ(run.peer().ReadOne("sensor_msgs/Imu", "rt/aibo/imu")["frame_id"], "aibo/base_link");
  EXPECT_EQ(run.peer().ReadOne("sensor_msgs/Image", "rt/aibo/image_raw")["width"], 352);
  EXPECT_EQ(run.End().status, 0) << run.program().heard();
}

TEST(Ros2FreeRunningTest, CommandsMoveJoints) {
  const Ros2Run run({"--place", "RCServer=net", "--free-running", "--body", "ideal"}, "5");
  run.WaitForStanding();
  run.peer().Do({"command", kCommandTopic, "neck_pan=0.5"});
  double position = 0;
  for (int i = 0; i < 40 && std::abs(position - 0.5) > 0.03; ++i)
    position = run.peer().Position("aibo", "neck_pan");
  EXPECT_NEAR(position, 0.5, 0.03);
}

}  // namespace
}  // namespace openr_host
