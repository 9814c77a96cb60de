// The two styles of a controller, run functions and endless loops, and controllers that mix them.
#include <device/led.h>
#include <device/servo.h>

#include "controller_fixture.h"

namespace openr_host {
namespace {

class ControllerLoopTest : public ControllerTest {
 protected:
  // main() is an endless loop of `body` and robot_step(step_ms).
  void Step(std::function<void()> body, int step_ms = 64) {
    g_main = [this, body, step_ms] {
      for (;;) {
        ++rounds;
        if (body) body();
        EXPECT_EQ(robot_step(step_ms), 0);
      }
    };
    CallMethod([this] { core.Execute(Main); });
  }

  int rounds = 0;
};

TEST_F(ControllerLoopTest, StepReturnsAtTheEndOfTheLedVector) {
  Step(nullptr);
  EXPECT_EQ(rounds, 1);
  EXPECT_EQ(leds.size(), 1u);
  led_ready = false;
  core.LedReady();
  EXPECT_EQ(rounds, 1);
  led_ready = true;
  core.LedReady();
  core.LedReady();
  EXPECT_EQ(rounds, 3);
  EXPECT_EQ(led_frames, (std::vector<int>{8, 8, 8}));
}

TEST_F(ControllerLoopTest, StepSendsWhatWasCommandedBeforeIt) {
  const DeviceTag eye = robot_get_device(kEye);
  const DeviceTag ear = robot_get_device(kLeftEar);
  const DeviceTag tilt = robot_get_device(kTilt);
  Step([=, this] {
    led_set(eye, rounds % 2);
    servo_set_position(ear, rounds % 2 ? 0.0f : 1.0f);
    servo_set_position(tilt, -0.1f * rounds);
  });
  core.LedReady();
  EXPECT_EQ(leds, (std::vector<uint32_t>{2, 0}));
  EXPECT_EQ(ears, (std::vector<uint32_t>{1, 0}));
  ASSERT_EQ(batches.size(), 2u);
  EXPECT_EQ(Joint(kTilt).position, -200000);
}

TEST_F(ControllerLoopTest, ValuesOfTheLoopWinOverRemoteOnes) {
  const DeviceTag eye = robot_get_device(kEye);
  Step([=] { led_set(eye, 0); });
  LedEarState change = {2 | 256, 2 | 256, 0, 0};
  core.RemoteLights(change);
  EXPECT_EQ(leds.size(), 1u) << "with the next iteration";
  core.LedReady();
  EXPECT_EQ(leds.back(), 256u);
}

TEST_F(ControllerLoopTest, StepsBetweenFramesAreRounded) {
  Step(nullptr, 50);
  EXPECT_EQ(led_frames, (std::vector<int>{6}));
  EXPECT_EQ(rounded, (std::vector<std::pair<int, int>>{{50, 48}}));
}

TEST_F(ControllerLoopTest, ALoopThatEndsLeavesTheLightsToTheRemoteControl) {
  g_main = [] {
    robot_step(64);
    robot_step(64);
  };
  core.Execute(Main);
  core.LedReady();
  core.LedReady();
  EXPECT_EQ(leds.size(), 3u);
  core.LedReady();
  EXPECT_EQ(leds.size(), 3u);
  LedEarState change = {1, 1, 0, 0};
  core.RemoteLights(change);
  EXPECT_EQ(leds.back(), 1u);
}

TEST_F(ControllerLoopTest, TheShutdownCallsDieAndTheLoopStandsStill) {
  g_main = [this] {
    robot_die(Die);
    for (;;) {
      ++rounds;
      robot_step(64);
    }
  };
  core.Execute(Main);
  core.Die();
  core.LedReady();
  EXPECT_EQ(g_die_count, 1);
  EXPECT_EQ(rounds, 1);
}

TEST_F(ControllerLoopTest, WithoutAStackMainEndsAtItsFirstStepAndTheRobotGoesOn) {
  has_loop_stack = false;
  Step(nullptr);
  EXPECT_EQ(rounds, 1);
  core.LedReady();
  EXPECT_EQ(rounds, 1);
  LedEarState change = {1, 1, 0, 0};
  core.RemoteLights(change);
  EXPECT_EQ(leds.back(), 1u);
}

TEST_F(ControllerLoopTest, WithoutAStackRunFunctionsWorkAsEver) {
  has_loop_stack = false;
  Loop(3, nullptr);
  EXPECT_EQ(g_arguments.size(), 3u);
}

TEST_F(ControllerLoopTest, StepInARunFunctionDoesNothing) {
  Loop(2, [] { EXPECT_EQ(robot_step(640), 0); });
  EXPECT_EQ(led_frames, (std::vector<int>{8, 8}));
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_EQ(remarks[0],
            "robot_step() outside of main() does nothing; a run function returns its time step "
            "instead");
}

TEST_F(ControllerLoopTest, StepAfterRunIsTheEndOfMain) {
  g_main = [this] {
    robot_run(RunOnce);
    for (;;) {
      ++rounds;
      robot_step(32);
    }
  };
  core.Execute(Main);
  core.LedReady();
  core.LedReady();
  EXPECT_EQ(rounds, 1);
  EXPECT_EQ(g_arguments.size(), 3u);
  EXPECT_EQ(led_frames, (std::vector<int>{8, 8, 8}));
  EXPECT_EQ(remarks.size(), 1u);
}

TEST_F(ControllerLoopTest, ExitInARunFunctionEndsTheController) {
  Loop(1, nullptr);
  g_run = []() -> int { throw MethodEnds(); };
  CallMethod([this] { core.LedReady(); });
  EXPECT_EQ(leds.size(), 1u);
  LedEarState change = {1, 1, 0, 0};
  core.RemoteLights(change);
  EXPECT_EQ(leds.back(), 1u) << "the remote control has the lights again";
  core.LedReady();
  EXPECT_EQ(g_arguments.size(), 2u);
}

TEST_F(ControllerLoopTest, ExitInMainEndsTheController) {
  has_loop_stack = false;
  g_main = [] {
    robot_run(RunOnce);
    throw MethodEnds();
  };
  CallMethod([this] { core.Execute(Main); });
  LedEarState change = {1, 1, 0, 0};
  core.RemoteLights(change);
  core.LedReady();
  EXPECT_EQ(g_arguments.size(), 1u);
}

int g_second_count;
int Second(int) {
  ++g_second_count;
  return 8;
}

TEST_F(ControllerLoopTest, ARunFunctionMayNameItsSuccessorForTheNextIteration) {
  g_second_count = 0;
  Loop(1, [] { robot_run(Second); });
  EXPECT_EQ(g_second_count, 0);
  core.LedReady();
  EXPECT_EQ(g_second_count, 1);
  EXPECT_EQ(led_frames, (std::vector<int>{8, 1}));
}

TEST_F(ControllerLoopTest, ANullRunFunctionEndsTheLoop) {
  Loop(1, [] { robot_run(nullptr); });
  core.LedReady();
  core.LedReady();
  EXPECT_EQ(g_arguments.size(), 1u);
}

TEST_F(ControllerLoopTest, TheLongestTimeStepIsThatOfAnLedCommand) {
  Loop(1, nullptr, 2147483647);
  EXPECT_EQ(led_frames, (std::vector<int>{65535}));
}

TEST_F(ControllerLoopTest, LiveAndDieTakeNoFunctionToo) {
  robot_live(nullptr);
  robot_die(nullptr);
  core.Die();
}

}  // namespace
}  // namespace openr_host
