// openr controller run: controllers outside of a robot that runs in real time or faster.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/openr/counting_proxy.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

namespace remote = openr::remote;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kHead[] = R"(
#include <stdlib.h>
#include <unistd.h>
#include <device/camera.h>
#include <device/distance_sensor.h>
#include <device/led.h>
#include <device/mtn.h>
#include <device/robot.h>
#include <device/servo.h>
#define PAN robot_get_device("PRM:/r1/c1/c2-Joint2:j2")
#define TILT robot_get_device("PRM:/r1/c1-Joint2:j1")
#define TAIL_LIGHT robot_get_device("PRM:/r6/l1-LED2:l1")
static void die(void) { robot_console_printf("died\n"); }
static int count;
)";

// Waits until `holds` returns true.  Returns false after 20 s.
template <typename Condition>
bool WaitUntil(const Condition& holds) {
  for (int i = 0; i < 2000; ++i) {
    if (holds()) return true;
    usleep(10'000);
  }
  return false;
}

// A robot that stands, and folders with controllers.
class ControllerRunTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    robot_ = new ProgramRun(
        {"run", "--rate", "4", "--no-panel", "--rc-port", "0", "--body", "ideal", "--json"});
    is_ready_ = robot_->WaitFor("state: accepting-commands") && robot_->WaitFor("openr rc 127.");
  }
  static void TearDownTestSuite() {
    robot_->Signal(SIGINT);
    delete robot_;
  }
  void SetUp() override { ASSERT_TRUE(is_ready_) << robot_->Finish().err; }

  static remote::Address RobotAddress() {
    const std::string& text = robot_->heard();
    const size_t begin = text.find("127.0.0.1:");
    return remote::ParseAddress(text.substr(begin, text.find(' ', begin) - begin));
  }

  // Begins to run a controller with the functions above, through the proxy.
  std::unique_ptr<ProgramRun> Start(const std::string& source,
                                    const std::string& timeout = "30s") const {
    folder_.Write("dog/main.c", kHead + source);
    return StartFolder(folder_.File("dog"), timeout);
  }
  std::unique_ptr<ProgramRun> StartFolder(const std::string& folder,
                                          const std::string& timeout = "30s") const {
    return std::make_unique<ProgramRun>(std::vector<std::string>{
        "controller", "run", folder, proxy_.address(), "--timeout", timeout});
  }
  ProgramResult Run(const std::string& source) const { return Start(source)->Finish(); }

  static ProgramRun* robot_;
  static bool is_ready_;
  const ScratchFolder folder_;
  CountingProxy proxy_{RobotAddress()};
};

ProgramRun* ControllerRunTest::robot_ = nullptr;
bool ControllerRunTest::is_ready_ = false;

// A run function that gives the same commands in each iteration until the joint has moved.
constexpr char kTurnsTheHead[] = R"(
static int run(int ms) {
  servo_set_velocity(PAN, 2.0f);
  servo_set_position(PAN, 0.5f);
  led_set(TAIL_LIGHT, 7);
  if (++count < 30 || servo_get_position(PAN) < 0.45f) return 32;
  robot_console_printf("turned, distance %d\n", distance_sensor_get_value(
      robot_get_device("PRM:/r1/c1/c2/c3/p1-Sensor:p1")) >= 100);
  robot_run(0);
  return 32;
}
int main(void) { servo_set_position(PAN, -0.2f); robot_die(die); robot_run(run); return 0; }
)";

TEST_F(ControllerRunTest, AJointMovesASensorIsReadAndCommandsGoOutOnlyWhenTheyChange) {
  const ProgramResult result = Run(kTurnsTheHead);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "turned, distance 1\ndied\n") << result.err;
  EXPECT_THAT(result.err, HasSubstr("the controller has ended: its loop has ended; "));
  EXPECT_THAT(result.err, HasSubstr("asked for were 32 ms each, achieved "));
  // main() commands -0.2 first, and 0.5 in the same iteration replaces it, so one MOVE goes out.
  using List = std::vector<std::pair<int, int>>;
  EXPECT_EQ(
      proxy_.requests(),
      (List{{rcINFO, -1}, {rcSUBSCRIBE, rcstreamSENSORS}, {rcMOVE, 1}, {rcSPEED, 1}, {rcLED, 7}}));
}

TEST_F(ControllerRunTest, TheLongestTimeLimitIsNotOverAtOnce) {
  const ProgramResult result = Start(kTurnsTheHead, "1000h")->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "turned, distance 1\ndied\n");
}

TEST_F(ControllerRunTest, AnEndlessLoopDoesTheSame) {
  const ProgramResult result = Run(R"(
int main(void) {
  robot_die(die);
  do {
    servo_set_position(TILT, -0.3f);
    robot_step(32);
  } while (servo_get_position(TILT) > -0.25f || ++count < 20);
  robot_console_printf("tilted\n");
  return 0;
}
)");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "tilted\ndied\n") << result.err;
  EXPECT_THAT(result.err, HasSubstr("its loop has ended; "));
  EXPECT_EQ(proxy_.Count(rcMOVE), 1);
}

TEST_F(ControllerRunTest, ACommandOfAnotherClientIsNotOverwritten) {
  remote::Connection other(RobotAddress());
  // Another test may have left the head where this controller wants it, so that the controller
  // would say "there" before its command is on its way.
  other.Move(1, 0);
  ASSERT_TRUE(WaitUntil([&] { return std::abs(other.GetSensors().joints[1]) < 100; }));
  const auto controller = Start(R"(
static int run(int ms) {
  static int was_there;
  float position = servo_get_position(PAN);
  servo_set_position(PAN, 0.4f);
  if (!was_there && position > 0.35f) {
    robot_console_printf("there\n");
    was_there = 1;
  }
  if (was_there && position < -0.25f && ++count == 20) robot_run(0);
  return 32;
}
int main(void) { robot_run(run); return 0; }
)");
  ASSERT_TRUE(controller->WaitForOutput("there\n")) << controller->Finish().err;
  other.Move(1, -20);
  const ProgramResult& result = controller->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(proxy_.Count(rcMOVE), 1);
  EXPECT_LT(other.GetSensors().joints[1], -1400);
}

TEST_F(ControllerRunTest, AMotorIsSwitchedOffAndOnAgainWithThePosition) {
  remote::Connection robot(RobotAddress());
  const int mouth = robot.Find(rcdeviceJOINT, "mouth");
  const auto controller = Start(R"(
#define MOUTH robot_get_device("PRM:/r1/c1/c2/c3/c4-Joint2:j4")
static int run(int ms) {
  if (count == 0) servo_motor_off(MOUTH);
  if (++count == 20) robot_console_printf("off\n");
  if (count == 60) servo_set_position(MOUTH, -0.5f);
  if (count > 60 && servo_get_position(MOUTH) < -0.45f) robot_run(0);
  return 32;
}
int main(void) { robot_run(run); return 0; }
)");
  ASSERT_TRUE(controller->WaitForOutput("off\n")) << controller->Finish().err;
  EXPECT_EQ(robot.GetGains(mouth).isOn, 0);
  EXPECT_EQ(controller->Finish().status, 0) << controller->Finish().err;
  EXPECT_EQ(robot.GetGains(mouth).isOn, 1);
  using List = std::vector<std::pair<int, int>>;
  List sent = proxy_.requests();
  sent.erase(sent.begin(), sent.begin() + 2);  // INFO and SUBSCRIBE
  EXPECT_EQ(sent, (List{{rcMOTOR_OFF, mouth}, {rcMOTOR_ON, mouth}, {rcMOVE, mouth}}));
}

TEST_F(ControllerRunTest, CtrlCEndsBothStylesByTheFunctionOfRobotDie) {
  for (const char* const source : {
           "static int run(int ms) { if (count++ == 3) robot_console_printf(\"runs\\n\");"
           " return 16; }\n"
           "int main(void) { robot_die(die); robot_run(run); return 0; }\n",
           "int main(void) { robot_die(die);\n"
           "  for (;;) { if (count++ == 3) robot_console_printf(\"runs\\n\"); robot_step(16); } "
           "}\n",
       }) {
    const auto controller = Start(source);
    ASSERT_TRUE(controller->WaitForOutput("runs\n")) << controller->Finish().err;
    controller->Signal(SIGINT);
    const ProgramResult& result = controller->Finish();
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out, "runs\ndied\n");
    EXPECT_THAT(result.err, HasSubstr("the controller has ended: Ctrl-C; "));
  }
}

constexpr char kGoesOnForEver[] = R"(
static int run(int ms) {
  servo_set_position(PAN, (++count & 1) * 0.1f);
  if (count == 3) robot_console_printf("runs\n");
  return 32;
}
int main(void) { robot_die(die); robot_run(run); return 0; }
)";

TEST_F(ControllerRunTest, ARobotThatAnswersNoMoreEndsTheController) {
  const auto controller = Start(kGoesOnForEver, "1s");
  ASSERT_TRUE(controller->WaitForOutput("runs\n")) << controller->Finish().err;
  proxy_.FallSilent();
  const ProgramResult& result = controller->Finish();
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "runs\ndied\n");
  EXPECT_THAT(result.err,
              HasSubstr(proxy_.address() + ": connected, but no answer within 1000 ms"));
  EXPECT_THAT(result.err, HasSubstr("the controller has ended: no connection to the robot; "));
}

TEST_F(ControllerRunTest, SilenceEndsAControllerThatCommandsNothing) {
  const auto controller = Start(R"(
int main(void) { for (;;) { if (++count == 3) robot_console_printf("runs\n"); robot_step(32); } }
)",
                                "1s");
  ASSERT_TRUE(controller->WaitForOutput("runs\n")) << controller->Finish().err;
  proxy_.FallSilent();
  const ProgramResult& result = controller->Finish();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("no answer within 1000 ms"));
}

TEST_F(ControllerRunTest, ALostConnectionEndsTheController) {
  const auto controller = Start(kGoesOnForEver);
  ASSERT_TRUE(controller->WaitForOutput("runs\n")) << controller->Finish().err;
  proxy_.End();
  const ProgramResult& result = controller->Finish();
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "runs\ndied\n");
  EXPECT_THAT(result.err, HasSubstr(proxy_.address() + ": the connection was lost ("));
}

TEST_F(ControllerRunTest, AMotionBesideTheControllerIsPutOnTheStickAndPlayed) {
  remote::Connection robot(RobotAddress());
  const std::string motion = robot.Download(rcfileMOTION, "BOW.MTN");
  folder_.Write("dog/mine.mtn", motion);
  const ProgramResult result = Run(R"(
static MTN *bow;
static int run(int ms) {
  count++;
  servo_set_position(PAN, 0.3f);
  if (mtn_get_time(bow) < mtn_get_length(bow) && !mtn_is_over(bow)) return 32;
  robot_console_printf("%d\n", count > 3 && mtn_get_time(bow) == mtn_get_length(bow));
  robot_run(0);
  return 32;
}
int main(void) {
  if (mtn_new("none.mtn") == 0) robot_console_printf("%s\n", mtn_get_error());
  bow = mtn_new("mine.mtn");
  if (mtn_get_error() != 0) robot_console_printf("%s\n", mtn_get_error());
  mtn_play(bow);
  robot_run(run);
  return 0;
}
)");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("NONE.MTN: no such file"));
  EXPECT_THAT(result.out, HasSubstr("\n1\n")) << result.err;
  EXPECT_THAT(result.err, HasSubstr("put on the robot's stick as MINE.MTN"));
  EXPECT_THAT(result.err, Not(HasSubstr("refused"))) << "positions wait for the end of the motion";
  EXPECT_EQ(robot.Download(rcfileMOTION, "MINE.MTN"), motion);
  robot.DeleteMotion("MINE.MTN");
}

TEST_F(ControllerRunTest, ImagesOfTheCameraCome) {
  const ProgramResult result = Run(R"(
int main(void) {
  DeviceTag camera = robot_get_device("PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1");
  unsigned char *image;
  camera_enable(camera, 32);
  if (camera_get_image(camera) != 0) robot_console_printf("too early\n");
  while ((image = camera_get_image(camera)) == 0) robot_step(32);
  robot_console_printf("%d x %d\n", camera_get_width(camera), camera_get_height(camera));
  for (count = 0; count < 176 * 144 * 3; count++) if (image[count] != image[0]) break;
  robot_console_printf("%s\n", count < 176 * 144 * 3 ? "a picture" : "one colour");
  return 0;
}
)");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "176 x 144\na picture\n") << result.err;
}

TEST_F(ControllerRunTest, AStepThatCannotBeHeldIsSaid) {
  const ProgramResult result = Run(R"(
int main(void) { while (++count < 4) { usleep(100000); robot_step(32); } return 0; }
)");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("the time step of 32 ms cannot be held: this iteration took "));
}

TEST_F(ControllerRunTest, AControllerThatIsAlwaysLateReadsNewValues) {
  const ProgramResult result = Run(R"(
int main(void) {
  float begin;
  robot_step(32);
  begin = servo_get_position(PAN);
  do {
    usleep(40000);
    servo_set_position(PAN, begin > 0 ? -0.4f : 0.4f);
    robot_step(8);
  } while (servo_get_position(PAN) * (begin > 0 ? -1 : 1) < 0.35f);
  return 0;
}
)");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(proxy_.Count(rcMOVE), 1);
}

TEST_F(ControllerRunTest, MistakesOfAControllerAreSaid) {
  const ProgramResult result = Run(R"(
int main(void) {
  robot_get_device("PRM:/r6/l1-LED2:l9");
  robot_step(33);
  return 0;
}
)");
  EXPECT_THAT(result.err, HasSubstr("there is no device 'PRM:/r6/l1-LED2:l9'"));
  EXPECT_THAT(result.err, HasSubstr("did you mean 'PRM:/r6/l1-LED2:l1'?"));
  EXPECT_THAT(result.err, HasSubstr("a time step of 33 ms is no multiple of 8; 32 ms are used"));
}

TEST_F(ControllerRunTest, WhatDoesNotCompileOrLinkRunsNothing) {
  EXPECT_EQ(Run("int main(void) { return undeclared; }").status, 1);
  const ProgramResult unlinked =
      Run("void nowhere(void);\nint main(void) { nowhere(); return 0; }");
  EXPECT_EQ(unlinked.status, 1);
  EXPECT_THAT(unlinked.err, HasSubstr("nowhere"));
  EXPECT_EQ(proxy_.requests().size(), 0u);
  EXPECT_EQ(StartFolder(folder_.File("missing"))->Finish().status, 1);
}

TEST_F(ControllerRunTest, ExamplesRunUnchanged) {
  // Lights; sensors and a joint; motions with a joint; a C++ program.
  for (const std::string name : {"lights", "paws", "wave", "states"}) {
    SCOPED_TRACE(name);
    CountingProxy proxy(RobotAddress());
    ProgramRun controller({"controller", "run", std::string(OPENR_EXAMPLE_CONTROLLERS) + "/" + name,
                           proxy.address()});
    const auto acts = [&] {
      return proxy.Count(rcLED) + proxy.Count(rcMOVE) + proxy.Count(rcMTN_PLAY) > 0;
    };
    EXPECT_TRUE(WaitUntil(acts));
    controller.Signal(SIGINT);
    EXPECT_EQ(controller.Finish().status, 0) << controller.Finish().err;
  }
}

TEST(ControllerRunFaultsTest, WhereNoRobotIsItSaysSo) {
  const ScratchFolder folder;
  folder.Write("main.c", "int main(void) { return 0; }\n");
  const ProgramResult result =
      RunProgram({"controller", "run", folder.File("main.c"), "127.0.0.1:1"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("127.0.0.1:1: no program listens there"));
  EXPECT_EQ(RunProgram({"controller", "run", folder.File("main.c"), "::1"}).status, 2);
}

}  // namespace
}  // namespace openr_host
