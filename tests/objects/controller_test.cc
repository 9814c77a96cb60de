// The controller's interface (include/device) on a robot that remembers what it was told.
#include <device/distance_sensor.h>
#include <device/led.h>
#include <device/mtn.h>
#include <device/robot.h>
#include <device/servo.h>
#include <device/touch_sensor.h>

#include <limits>

#include "MoverState.h"
#include "controller_fixture.h"

namespace openr_host {
namespace {

TEST_F(ControllerTest, RunIsCalledAtOnceThenAtEveryEndOfALedVectorAlwaysWithZero) {
  Loop(4, nullptr);
  EXPECT_EQ(g_arguments, (std::vector<int>{0, 0, 0, 0}));
  EXPECT_EQ(leds.size(), 4u);
  EXPECT_EQ(led_frames, (std::vector<int>{8, 8, 8, 8}));
}

TEST_F(ControllerTest, RobotRunReturnsAndWhatFollowsIsCarriedOut) {
  bool after = false;
  g_main = [&] {
    robot_run(RunOnce);
    after = true;
  };
  core.Execute(Main);
  EXPECT_TRUE(after);
}

TEST_F(ControllerTest, LiveCallsItsFunctionOnceAndDieWaitsForTheShutdown) {
  g_main = [] {
    robot_live(Reset);
    robot_die(Die);
  };
  core.Execute(Main);
  EXPECT_EQ(g_reset_count, 1);
  EXPECT_EQ(g_die_count, 0);
  core.Die();
  core.Die();
  EXPECT_EQ(g_die_count, 1);
}

TEST_F(ControllerTest, UnchangedLedsAreSentAgainToKeepTheLoop) {
  const DeviceTag eye = robot_get_device(kEye);
  Loop(1, [=] { led_set(eye, 1); });
  g_run = [] { return 64; };
  core.LedReady();
  core.LedReady();
  EXPECT_EQ(leds, (std::vector<uint32_t>{2, 2, 2}));
}

TEST_F(ControllerTest, TheTimeStepMayChangeFromCallToCall) {
  int step = 0;
  g_run = [&] { return ++step * 8; };
  core.Execute(Main);
  core.LedReady();
  core.LedReady();
  EXPECT_EQ(led_frames, (std::vector<int>{1, 2, 3}));
}

TEST_F(ControllerTest, ATimeStepBetweenFramesIsRoundedAndSaidSo) {
  Loop(1, nullptr, 30);
  EXPECT_EQ(led_frames, (std::vector<int>{4}));
  EXPECT_EQ(rounded, (std::vector<std::pair<int, int>>{{30, 32}}));
}

TEST_F(ControllerTest, ATimeStepOfNothingBecomesOneFrame) {
  Loop(1, nullptr, 0);
  EXPECT_EQ(led_frames, (std::vector<int>{1}));
}

TEST_F(ControllerTest, AReadyEventOfAVectorThatWaitedDoesNotCallRun) {
  Loop(1, nullptr);
  led_ready = false;
  core.LedReady();
  EXPECT_EQ(g_arguments.size(), 1u);
}

TEST_F(ControllerTest, LedsAreOnForAnyValueButZero) {
  const DeviceTag eye = robot_get_device(kEye);
  Loop(1, [=] { led_set(eye, 200); });
  EXPECT_EQ(leds.back(), 2u);
  g_run = [=] {
    led_set(eye, 0);
    return 64;
  };
  core.LedReady();
  EXPECT_EQ(leds.back(), 0u);
}

TEST_F(ControllerTest, EarsGoInAVectorOfTheirOwnOnlyWhenTheyChange) {
  const DeviceTag ear = robot_get_device(kLeftEar);
  Loop(3, [=] { servo_set_position(ear, 0.0f); });
  EXPECT_EQ(ears, (std::vector<uint32_t>{1}));
}

TEST_F(ControllerTest, EarIsOnAtZeroAndOffAnywhereElse) {
  const DeviceTag ear = robot_get_device(kLeftEar);
  Loop(1, [=] { servo_set_position(ear, 0.0f); });
  g_run = [=] {
    servo_set_position(ear, 1.2f);
    return 64;
  };
  core.LedReady();
  EXPECT_EQ(ears, (std::vector<uint32_t>{1, 0}));
}

TEST_F(ControllerTest, AnEarCommandIsTriedAgainInTheNextIterationWhenNotReady) {
  const DeviceTag ear = robot_get_device(kLeftEar);
  ear_ready = false;
  Loop(3, [=] { servo_set_position(ear, 0.0f); });
  EXPECT_TRUE(ears.empty());
  ear_ready = true;
  core.LedReady();
  EXPECT_EQ(ears, (std::vector<uint32_t>{1}));
}

TEST_F(ControllerTest, TheJointBufferIsSentOnlyWhenSomethingChanged) {
  const DeviceTag tilt = robot_get_device(kTilt);
  Loop(5, [=] { servo_set_position(tilt, -0.5f); });
  ASSERT_EQ(batches.size(), 1u);
  EXPECT_EQ(Joint(kTilt).position, -500000);
  EXPECT_EQ(Joint(kTilt).flags, batchPOSITION_GIVEN);
}

TEST_F(ControllerTest, TheJointBufferWaitsForJointMover) {
  const DeviceTag tilt = robot_get_device(kTilt);
  batch_ready = false;
  Loop(2, [=] { servo_set_position(tilt, -0.5f); });
  EXPECT_TRUE(batches.empty());
  batch_ready = true;
  core.LedReady();
  EXPECT_EQ(batches.size(), 1u);
}

TEST_F(ControllerTest, ValuesBeyondTheLimitsBecomeTheLimit) {
  const DeviceTag tilt = robot_get_device(kTilt);
  Loop(1, [=] {
    servo_set_position(tilt, 1e30f);
    servo_set_velocity(tilt, 1000.0f);
    servo_set_acceleration(tilt, -1.0f);
  });
  EXPECT_EQ(Joint(kTilt).position, 750492);
  EXPECT_EQ(Joint(kTilt).speed, 12062);
  EXPECT_EQ(Joint(kTilt).acceleration, 313);
}

TEST_F(ControllerTest, NotANumberIsNoCommand) {
  const DeviceTag tilt = robot_get_device(kTilt);
  Loop(1, [=] {
    servo_set_position(tilt, std::numeric_limits<float>::quiet_NaN());
    servo_set_velocity(tilt, std::numeric_limits<float>::quiet_NaN());
  });
  EXPECT_TRUE(batches.empty());
}

TEST_F(ControllerTest, MotorOffLastsUntilTheNextPosition) {
  const DeviceTag tilt = robot_get_device(kTilt);
  Loop(1, [=] { servo_motor_off(tilt); });
  EXPECT_EQ(Joint(kTilt).flags, batchMOTOR_OFF);
  g_run = [=] {
    servo_set_position(tilt, 0.0f);
    return 64;
  };
  core.LedReady();
  EXPECT_EQ(Joint(kTilt).flags, batchPOSITION_GIVEN);
}

TEST_F(ControllerTest, RemoteLightsGoOutWithTheNextIteration) {
  Loop(1, nullptr);
  LedEarState change = {1u << 8, 1u << 8, 0, 0};
  core.RemoteLights(change);
  EXPECT_EQ(leds.size(), 1u);
  core.LedReady();
  EXPECT_EQ(leds.back(), 1u << 8);
}

TEST_F(ControllerTest, ValuesOfTheRunFunctionWinOverRemoteOnes) {
  const DeviceTag eye = robot_get_device(kEye);
  Loop(1, [=] { led_set(eye, 0); });
  LedEarState change = {2, 2, 0, 0};
  core.RemoteLights(change);
  core.LedReady();
  EXPECT_EQ(leds.back(), 0u);
}

TEST_F(ControllerTest, RemoteLightsWorkWithoutAController) {
  LedEarState change = {1, 1, 2, 2};
  core.RemoteLights(change);
  EXPECT_EQ(leds, (std::vector<uint32_t>{1}));
  EXPECT_EQ(ears, (std::vector<uint32_t>{2}));
}

TEST_F(ControllerTest, RemoteLightsWithoutAControllerWaitForTheEffector) {
  led_ready = false;
  LedEarState change = {1, 1, 0, 0};
  core.RemoteLights(change);
  EXPECT_TRUE(leds.empty());
  led_ready = true;
  core.LedReady();
  core.LedReady();
  EXPECT_EQ(leds, (std::vector<uint32_t>{1}));
}

TEST_F(ControllerTest, SensorsAreReadInTheirUnits) {
  Sense(kTilt, -1234567);
  Sense(kPsd, 456789);
  Sense(kPaw, 1);
  EXPECT_FLOAT_EQ(servo_get_position(robot_get_device(kTilt)), -1.234567f);
  EXPECT_EQ(distance_sensor_get_value(robot_get_device(kPsd)), 456);
  EXPECT_EQ(touch_sensor_get_value(robot_get_device(kPaw)), 1);
  EXPECT_FLOAT_EQ(robot_battery_sensor_get_value(), 87.0f);
}

TEST_F(ControllerTest, AHeadSensorIsTouchedBeyondHalfOfItsRange) {
  Sense(kHead, 490332);
  EXPECT_EQ(touch_sensor_get_value(robot_get_device(kHead)), 0);
  Sense(kHead, 490333);
  EXPECT_EQ(touch_sensor_get_value(robot_get_device(kHead)), 1);
}

TEST_F(ControllerTest, UnknownDevicesReadZeroAndTakeNoCommands) {
  const DeviceTag none = robot_get_device("PRM:/r9/c1-Joint2:j1");
  EXPECT_EQ(none, 0);
  Loop(1, [=] {
    for (const DeviceTag tag : {DeviceTag{0}, DeviceTag{999}, DeviceTag{65535}}) {
      servo_set_position(tag, 1.0f);
      servo_motor_off(tag);
      led_set(tag, 1);
      EXPECT_EQ(servo_get_position(tag), 0.0f);
      EXPECT_EQ(distance_sensor_get_value(tag), 0);
      EXPECT_EQ(touch_sensor_get_value(tag), 0);
    }
  });
  EXPECT_TRUE(batches.empty());
  EXPECT_EQ(leds.back(), 0u);
  EXPECT_EQ(robot_get_device(nullptr), 0);
}

TEST_F(ControllerTest, AnUnknownDeviceIsRemarkedUponOnceForEachName) {
  for (int i = 0; i < 3; ++i) {
    robot_get_device("PRM:/r1/c1-Joint2:j9");
    robot_get_device("PRM:/r1/c1-Joint2:j1");
    robot_get_device("wheel");
  }
  EXPECT_EQ(unknown, (std::vector<std::string>{"PRM:/r1/c1-Joint2:j9", "wheel"}));
}

TEST_F(ControllerTest, AskingWhetherADeviceExistsIsNotRemarkedUpon) {
  EXPECT_EQ(robot_has_device("wheel"), 0);
  EXPECT_EQ(robot_has_device(nullptr), 0);
  EXPECT_EQ(robot_has_device(kEye), 1);
  EXPECT_EQ(robot_has_device("PRM:/r1/c1-Joint2:j1"), 1);
  EXPECT_TRUE(unknown.empty());
}

TEST_F(ControllerTest, EarsFollowAMotionAndTheOtherEarStays) {
  core.MotionEars(1, 1);
  EXPECT_EQ(ears, (std::vector<uint32_t>{1}));
  core.MotionEars(1, 1);
  EXPECT_EQ(ears.size(), 1u) << "nothing has changed";
  core.MotionEars(2, 2);
  core.MotionEars(1, 0);
  EXPECT_EQ(ears, (std::vector<uint32_t>{1, 3, 2}));
}

TEST_F(ControllerTest, EarsOfAMotionWaitForTheNextIterationOfALoop) {
  Loop(1, nullptr);
  core.MotionEars(3, 2);
  EXPECT_TRUE(ears.empty());
  core.LedReady();
  EXPECT_EQ(ears, (std::vector<uint32_t>{2}));
}

TEST_F(ControllerTest, EarsOfAMotionWaitWhileTheEarsMoveAndTheNewestWins) {
  ear_ready = false;
  core.MotionEars(3, 1);
  core.MotionEars(3, 3);
  ear_ready = true;
  core.EarReady();
  EXPECT_EQ(ears, (std::vector<uint32_t>{3}));
}

TEST_F(ControllerTest, ACallerWithEverNewNamesIsHeardForAWhile) {
  for (int i = 0; i < 100; ++i) robot_get_device(std::to_string(i).c_str());
  EXPECT_EQ(unknown.size(), 32u);
}

TEST_F(ControllerTest, DevicesOfAnotherKindReadZero) {
  Sense(kThermo, 30000000);
  Sense(kPsd, 456789);
  EXPECT_EQ(distance_sensor_get_value(robot_get_device(kThermo)), 0);
  EXPECT_EQ(touch_sensor_get_value(robot_get_device(kPsd)), 0);
  EXPECT_EQ(servo_get_position(robot_get_device(kLeftEar)), 0.0f);
}

TEST_F(ControllerTest, ModeIsCrossCompilation) { EXPECT_EQ(robot_get_mode(), 1); }

TEST_F(ControllerTest, AMotionIsLoadedByItsBareName) {
  AddMotion("NOD.MTN", MtnBytes::OneJoint(kTilt, {0, 10, 20}, 2));
  MTN* motion = mtn_new("nod.mtn");
  ASSERT_NE(motion, nullptr);
  EXPECT_EQ(mtn_get_error(), nullptr);
  EXPECT_EQ(mtn_get_length(motion), 2 * 3 * 16);
  EXPECT_EQ(mtn_get_time(motion), mtn_get_length(motion));
  EXPECT_EQ(mtn_is_over(motion), 1);
  mtn_delete(motion);
}

TEST_F(ControllerTest, AMotionThatCannotBeLoadedIsNullWithAReason) {
  AddMotion("SEVEN.MTN", MtnBytes::OneJoint("PRM:/r1/c1-Joint2:11", {0, 1}));
  AddMotion("GOOD.MTN", MtnBytes::OneJoint(kTilt, {0, 1}));
  EXPECT_EQ(mtn_new("NONE.MTN"), nullptr);
  EXPECT_STREQ(mtn_get_error(), "/MS/OPEN-R/MW/DATA/P/NONE.MTN: no such file on the Memory Stick");
  EXPECT_EQ(mtn_new("SEVEN.MTN"), nullptr);
  EXPECT_STREQ(
      mtn_get_error(),
      "SEVEN.MTN: section 2, offset 86: joint 0: the ERS-210 has no joint 'PRM:/r1/c1-Joint2:11'");
  EXPECT_EQ(mtn_new("/MS/OPEN-R/MW/DATA/P/GOOD.MTN"), nullptr);
  EXPECT_EQ(mtn_new(nullptr), nullptr);
  MTN* good = mtn_new("GOOD.MTN");
  EXPECT_EQ(mtn_get_error(), nullptr) << "reset by the next call";
  mtn_delete(good);
}

TEST_F(ControllerTest, ANullMotionHasNoLengthAndIsOver) {
  mtn_play(nullptr);
  mtn_delete(nullptr);
  EXPECT_EQ(mtn_get_length(nullptr), 0);
  EXPECT_EQ(mtn_get_time(nullptr), 0);
  EXPECT_EQ(mtn_is_over(nullptr), 1);
  EXPECT_TRUE(movers.empty());
}

TEST_F(ControllerTest, PlayingFollowsTheKeyFrames) {
  AddMotion("NOD.MTN", MtnBytes::OneJoint(kTilt, {0, 10, 20, 30}, 1));
  MTN* motion = mtn_new("NOD.MTN");
  mtn_play(motion);
  ASSERT_EQ(movers.size(), 1u);
  EXPECT_EQ(movers[0].kind, moverkindPLAY);
  EXPECT_EQ(movers[0].loops, 1);
  EXPECT_STREQ(movers[0].file, "NOD.MTN");
  EXPECT_EQ(mtn_is_over(motion), 0) << "before JointMover has said anything";
  Tell("NOD.MTN", moverPREPARE_MTN, -1);
  EXPECT_EQ(mtn_is_over(motion), 0);
  Tell("NOD.MTN", moverMTN, 2);
  EXPECT_EQ(mtn_get_time(motion), 2 * 2 * 16);
  Tell("OTHER.MTN", moverMTN, 1);
  EXPECT_EQ(mtn_get_time(motion), 2 * 2 * 16) << "the remote control plays another";
  Tell("NOD.MTN", moverMTN, 3);
  EXPECT_EQ(mtn_is_over(motion), 1);
  Tell("NOD.MTN", moverACCEPTING_COMMANDS, -1, true);
  EXPECT_EQ(mtn_is_over(motion), 1);
  EXPECT_EQ(mtn_get_time(motion), mtn_get_length(motion));
  mtn_delete(motion);
}

TEST_F(ControllerTest, ARefusedMotionIsOver) {
  AddMotion("NOD.MTN", MtnBytes::OneJoint(kTilt, {0, 10, 20}));
  MTN* motion = mtn_new("NOD.MTN");
  mtn_play(motion);
  Tell("NOD.MTN", moverMTN, -1, true);
  EXPECT_EQ(mtn_is_over(motion), 1);
  mtn_delete(motion);
}

TEST_F(ControllerTest, AMotionIsNotStartedWhileAnotherPlays) {
  AddMotion("NOD.MTN", MtnBytes::OneJoint(kTilt, {0, 10, 20}));
  AddMotion("BOW.MTN", MtnBytes::OneJoint(kTilt, {0, 5}));
  MTN* nod = mtn_new("NOD.MTN");
  MTN* bow = mtn_new("BOW.MTN");
  mtn_play(nod);
  Tell("NOD.MTN", moverMTN, 1);
  mtn_play(bow);
  mtn_play(nod);
  EXPECT_EQ(movers.size(), 1u);
  EXPECT_EQ(remarks.size(), 2u);
  EXPECT_EQ(mtn_is_over(nod), 0);
  EXPECT_EQ(mtn_is_over(bow), 1) << "it does not play";
  Tell("NOD.MTN", moverMTN, 2);
  mtn_play(bow);
  EXPECT_EQ(movers.size(), 2u) << "the last key frame is reached";
  EXPECT_EQ(mtn_is_over(bow), 0);
  mtn_delete(nod);
  mtn_delete(bow);
}

TEST_F(ControllerTest, AMotionDeletedWhilePlayingIsForgotten) {
  AddMotion("NOD.MTN", MtnBytes::OneJoint(kTilt, {0, 10, 20}));
  MTN* motion = mtn_new("NOD.MTN");
  mtn_play(motion);
  mtn_delete(motion);
  Tell("NOD.MTN", moverMTN, 1);
}

TEST(ControllerApiTest, WithoutARobotEverythingIsZeroAndNothingCrashes) {
  SetControllerCore(nullptr);
  led_set(1, 1);
  servo_set_position(1, 1.0f);
  servo_motor_off(1);
  robot_live(Reset);
  robot_run(RunOnce);
  robot_die(Die);
  EXPECT_EQ(robot_get_device(kTilt), 0);
  EXPECT_EQ(servo_get_position(1), 0.0f);
  EXPECT_EQ(robot_battery_sensor_get_value(), 0.0f);
  EXPECT_EQ(mtn_new("A.MTN"), nullptr);
}

}  // namespace
}  // namespace openr_host
