// Tests the requests that `openr controller run` sends for a controller's changes, and its pace.
#include <gtest/gtest.h>

#include <cstring>

#include "Angle.h"
#include "openr/controller/joint_commands.h"
#include "openr/controller/step_clock.h"

namespace openr_host {
namespace {

using std::chrono::milliseconds;

class JointCommandsTest : public testing::Test {
 protected:
  JointCommandsTest() {
    // The buffer of ControllerCore before the first command.
    std::memset(&buffer_, 0, sizeof buffer_);
    for (int j = 0; j < robot_->numJoints; ++j) {
      buffer_.joint[j].speed = robot_->joints[j].maxSpeedCdeg;
      buffer_.joint[j].acceleration = robot_->defaultAccelerationCdeg;
    }
  }

  void Move(int joint, Sint32 cdeg) {
    buffer_.joint[joint].position = UradFromCdeg(cdeg);
    buffer_.joint[joint].flags = batchPOSITION_GIVEN;
  }

  // Returns the requests for the changes, each as its command and joint.
  std::vector<std::pair<int, int>> Sent(bool is_playing = false) {
    std::vector<std::pair<int, int>> sent;
    for (const RobotCommand& command : commands_.Changes(buffer_, is_playing)) {
      sent.emplace_back(command.call.command, command.call.payload[0]);
    }
    return sent;
  }
  using List = std::vector<std::pair<int, int>>;

  const RobotConstants* const robot_ = FindRobot("ERS-210");
  BatchMoverCommand buffer_;
  JointCommands commands_{robot_};
};

TEST_F(JointCommandsTest, NothingIsSentBeforeTheFirstCommand) { EXPECT_EQ(Sent(), List()); }

TEST_F(JointCommandsTest, PositionsComeBeforeSpeedsAndSpeedsBeforeAccelerations) {
  for (const int joint : {1, 3}) {
    buffer_.joint[joint].acceleration -= 100;
    buffer_.joint[joint].speed -= 100;
    Move(joint, -500);
  }
  EXPECT_EQ(
      Sent(),
      (List{{rcMOVE, 1}, {rcMOVE, 3}, {rcSPEED, 1}, {rcSPEED, 3}, {rcACCEL, 1}, {rcACCEL, 3}}));
}

TEST_F(JointCommandsTest, AValueIsSentOnlyWhenItChanges) {
  Move(1, 3000);
  EXPECT_EQ(Sent(), (List{{rcMOVE, 1}}));
  EXPECT_EQ(Sent(), List());
  buffer_.joint[1].position += 1;  // less than the 0.01 degree of the protocol
  EXPECT_EQ(Sent(), List());
  Move(1, 3001);
  EXPECT_EQ(Sent(), (List{{rcMOVE, 1}}));
}

TEST_F(JointCommandsTest, AJointThatWasSwitchedOffIsSwitchedOnWithItsPosition) {
  Move(2, 500);
  EXPECT_EQ(Sent(), (List{{rcMOVE, 2}}));
  buffer_.joint[2].flags |= batchMOTOR_OFF;
  EXPECT_EQ(Sent(), (List{{rcMOTOR_OFF, 2}}));
  EXPECT_EQ(Sent(), List());
  Move(2, 500);
  EXPECT_EQ(Sent(), (List{{rcMOTOR_ON, 2}, {rcMOVE, 2}})) << "the same position as before";
}

TEST_F(JointCommandsTest, PositionsWaitForTheEndOfAMotionAndLimitsDoNot) {
  Move(1, 3000);
  buffer_.joint[1].speed -= 100;
  EXPECT_EQ(Sent(true), (List{{rcSPEED, 1}}));
  EXPECT_EQ(Sent(true), List());
  EXPECT_EQ(Sent(), (List{{rcMOVE, 1}}));
}

TEST_F(JointCommandsTest, ARefusedPositionIsSentAgain) {
  Move(1, 3000);
  EXPECT_EQ(Sent(), (List{{rcMOVE, 1}}));
  commands_.Forget(1);
  EXPECT_EQ(Sent(), (List{{rcMOVE, 1}}));
}

class StepClockTest : public testing::Test {
 protected:
  // Makes an iteration of 32 ms whose successor begins `late` after its time.
  std::string Iterate(int late_ms) {
    now_ns_ = clock_.Next(now_ns_, 32 * kNsPerMs) + late_ms * kNsPerMs;
    return clock_.Begin(now_ns_);
  }

  static constexpr int64_t kNsPerMs = 1'000'000;
  StepClock clock_;
  int64_t now_ns_ = 3'600'000 * kNsPerMs;
};

TEST_F(StepClockTest, IterationsThatBeginALittleLateAreMadeUpFor) {
  const int64_t begin_ns = now_ns_;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(Iterate(5), "");
  EXPECT_EQ(clock_.Next(now_ns_, 32 * kNsPerMs) - begin_ns, 11 * 32 * kNsPerMs);
  EXPECT_EQ(clock_.Summary(),
            "10 iterations in 0.3 s; asked for were 32 ms each, achieved 32.5 ms on average, "
            "37 ms at most");
}

TEST_F(StepClockTest, AStepThatIsNotHeldIsSaidOnceASecond) {
  EXPECT_EQ(Iterate(68), "the time step of 32 ms cannot be held: this iteration took 100 ms");
  for (int i = 0; i < 10; ++i) EXPECT_EQ(Iterate(64), "") << i;
  EXPECT_EQ(Iterate(64), "the time step of 32 ms cannot be held: this iteration took 96 ms");
}

TEST_F(StepClockTest, ALostIterationIsNotMadeUpFor) {
  Iterate(500);
  EXPECT_EQ(clock_.Next(now_ns_, 32 * kNsPerMs), now_ns_ + 32 * kNsPerMs);
}

TEST_F(StepClockTest, WithoutAnIterationThereIsNothingToSay) {
  EXPECT_EQ(clock_.Summary(), "no iteration");
}

}  // namespace
}  // namespace openr_host
