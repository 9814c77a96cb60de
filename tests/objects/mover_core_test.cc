#include <gtest/gtest.h>

#include <cstdlib>

#include "mover_dog.h"

namespace openr_host {
namespace {

constexpr const char* kTilt = "PRM:/r1/c1-Joint2:j1";
constexpr const char* kLfJ1 = "PRM:/r2/c1-Joint2:j1";
constexpr const char* kTail = "PRM:/r6/c1-Joint2:j1";
constexpr int32_t kDeg10 = 174533;

TEST(MoverCoreTest, StartsThroughTheStatesOfTheReport) {
  Dog dog;
  dog.Play();
  EXPECT_EQ(dog.said, (std::vector<std::string>{"filling", "gains", "broadbase", "sleeping",
                                                "crouching", "standing", "accepting-commands"}));
  EXPECT_EQ(dog.times_standing, 1);
}

TEST(MoverCoreTest, StandsAfterLessThan13Seconds) {
  Dog dog;
  dog.Play();
  EXPECT_LT(dog.frames.size() * 0.008, 13.0) << dog.frames.size();
  EXPECT_GT(dog.frames.size() * 0.008, 10.0);
  const PostureConstants* stand = FindPosture(dog.robot, "stand");
  for (int j = 0; j < dog.robot->numJoints; ++j)
    EXPECT_EQ(dog.angle[j], stand->urad[j]) << dog.robot->joints[j].name;
}

TEST(MoverCoreTest, FirstVectorHoldsWhatWasMeasuredAndGainsComeAfterIt) {
  Dog dog;
  const std::map<int, int32_t> measured = dog.angle;
  dog.PlayVector();
  ASSERT_EQ(dog.frames.size(), 4u);
  for (const auto& frame : dog.frames) EXPECT_EQ(frame, measured);
  for (int j = 0; j < dog.robot->numJoints; ++j) EXPECT_TRUE(dog.gain[j]) << j;
}

TEST(MoverCoreTest, StartUpStaysInsideSoftwareLimitsAndSpeeds) {
  Dog dog;
  dog.Play();
  for (size_t f = 1; f < dog.frames.size(); ++f) {
    for (int j = 0; j < dog.robot->numJoints; ++j) {
      const JointConstants& limits = dog.robot->joints[j];
      ASSERT_GE(dog.frames[f][j], limits.minUrad);
      ASSERT_LE(dog.frames[f][j], limits.maxUrad);
      ASSERT_LE(std::abs(dog.frames[f][j] - dog.frames[f - 1][j]),
                limits.maxSpeedCdeg * 1.3963 + 1);
    }
  }
}

TEST(MoverCoreTest, ARobotWithoutACrouchingPostureLeavesItOut) {
  RobotConstants robot = *FindRobot("ERS-210");
  std::vector<PostureConstants> postures;
  for (int i = 0; i < robot.numPostures; ++i) {
    if (std::string(robot.postures[i].name) != "crouch") postures.push_back(robot.postures[i]);
  }
  ASSERT_EQ(static_cast<int>(postures.size()), robot.numPostures - 1);
  robot.numPostures = static_cast<int>(postures.size());
  robot.postures = postures.data();
  Dog dog(&robot);
  dog.Play();
  EXPECT_EQ(dog.said, (std::vector<std::string>{"filling", "gains", "broadbase", "sleeping",
                                                "standing", "accepting-commands"}));
}

TEST(MoverCoreTest, AnIdleDogSendsNothing) {
  StandingDog dog;
  EXPECT_FALSE(dog.PlayVector());
}

TEST(MoverCoreTest, CommandsBeforeStandingHaveNoEffect) {
  Dog dog;
  dog.PlayUntil(moverCROUCHING);
  dog.Move(kTail, kDeg10);
  EXPECT_NE(dog.Start(MtnBytes::OneJoint(kTilt, {0})), "");
  dog.Play();
  EXPECT_EQ(dog.angle[dog.Joint(kTail)], 0);
}

TEST(MoverCoreTest, APositionIsReachedExactly) {
  StandingDog dog;
  dog.Move(kTilt, -kDeg10);
  dog.Play();
  EXPECT_EQ(dog.angle[dog.Joint(kTilt)], -kDeg10);
}

TEST(MoverCoreTest, APositionBeyondTheLimitEndsAtTheLimit) {
  StandingDog dog;
  dog.Move(kTilt, 2147483647);
  dog.Play();
  EXPECT_EQ(dog.angle[dog.Joint(kTilt)], dog.robot->joints[dog.Joint(kTilt)].maxUrad);
}

TEST(MoverCoreTest, JointsThatDoNotExistAreIgnored) {
  StandingDog dog;
  for (const int joint : {-1, 18, 100000}) {
    MoverCommand command = {moverkindPOSITION, joint, 0, {0}, 0, {}, {}};
    dog.core.MoveJoint(command);
  }
  EXPECT_FALSE(dog.PlayVector());
}

TEST(MoverCoreTest, SpeedLimitSlowsTheJoint) {
  StandingDog dog;
  dog.Command(moverkindSPEED, kTilt, 500);  // 5 degree/s
  dog.Move(kTilt, -kDeg10);
  dog.Play();
  EXPECT_GT(dog.frames.size() * 0.008, 2.0);
}

TEST(MoverCoreTest, SpeedsBeyondTheTableBecomeItsLimits) {
  StandingDog dog;
  dog.Command(moverkindSPEED, kTilt, 0);
  dog.Move(kTilt, -kDeg10);
  dog.Play();
  EXPECT_NEAR(dog.frames.size() * 0.008, 4.0, 0.2);  // at the smallest speed, 2.5 degree/s
}

TEST(MoverCoreTest, MotionNearItsFirstKeyFrameBeginsAtOnce) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {785397, 0})), "");
  EXPECT_EQ(dog.said, (std::vector<std::string>{"mtn"}));
}

TEST(MoverCoreTest, MotionFarFromItsFirstKeyFrameIsPrepared) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {-785398, 0})), "");
  EXPECT_EQ(dog.said, (std::vector<std::string>{"prepare-mtn"}));
  dog.Play();
  EXPECT_EQ(dog.said, (std::vector<std::string>{"prepare-mtn", "mtn", "accepting-commands"}));
  EXPECT_EQ(dog.angle[dog.Joint(kTilt)], 0);
}

TEST(MoverCoreTest, PreparationEndsAtTheFirstKeyFrameWithinTheSpeedLimit) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kLfJ1, {1000000, 1000000})), "");
  dog.PlayUntil(moverMTN);
  EXPECT_EQ(dog.angle[dog.Joint(kLfJ1)], 1000000);
  for (size_t f = 1; f < dog.frames.size(); ++f) {
    ASSERT_LE(std::abs(dog.frames[f][dog.Joint(kLfJ1)] - dog.frames[f - 1][dog.Joint(kLfJ1)]),
              16125 * 1.3963 + 1);
  }
}

TEST(MoverCoreTest, PlayBackIgnoresTheSpeedLimit) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {0, -700000, 0})), "");
  dog.Play();
  ASSERT_EQ(dog.frames.size(), 4u);
  EXPECT_EQ(dog.frames[1][dog.Joint(kTilt)], -700000);
}

TEST(MoverCoreTest, EveryVectorOfAMotionReportsItsKeyFrameAndTheEndMinusOne) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {0, 10, 20, 30, 40, 50})), "");
  dog.Play();
  std::vector<int> key_frames;
  for (const SetValueMessage& report : dog.reports) key_frames.push_back(report.keyFrame);
  EXPECT_EQ(key_frames, (std::vector<int>{0, 2, 4, 5, -1}));
  EXPECT_STREQ(dog.reports.back().file, "TEST.MTN");
  EXPECT_EQ(dog.reports.back().state, moverACCEPTING_COMMANDS);
  for (const SetValueMessage& report : dog.reports) EXPECT_EQ(report.isOver, report.keyFrame == -1);
  EXPECT_EQ(dog.reports[2].commanded[dog.Joint(kTilt)], 40);
  EXPECT_EQ(dog.reports[2].measured[dog.Joint(kTilt)], 40);
}

TEST(MoverCoreTest, LoopsPlayWithoutPreparationBetweenThem) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kLfJ1, {-kDeg10, 900000}), 3), "");
  dog.Play();
  EXPECT_EQ(dog.frames.size(), 6u);
  EXPECT_EQ(dog.said, (std::vector<std::string>{"mtn", "accepting-commands"}));
}

TEST(MoverCoreTest, ASingleKeyFrameIsAPostureToGoTo) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {-kDeg10})), "");
  dog.Play();
  EXPECT_EQ(dog.angle[dog.Joint(kTilt)], -kDeg10);
  EXPECT_EQ(dog.said, (std::vector<std::string>{"prepare-mtn", "mtn", "accepting-commands"}));
}

TEST(MoverCoreTest, ASingleKeyFrameWhereTheRobotIsEndsAtOnce) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {0})), "");
  EXPECT_TRUE(dog.core.AcceptsMotion());
  EXPECT_FALSE(dog.PlayVector());
}

TEST(MoverCoreTest, ABrokenMotionIsRefusedAndNothingMoves) {
  StandingDog dog;
  MtnBytes mtn = MtnBytes::OneJoint(kTilt, {0, 10});
  mtn.magic = "ABCD";
  EXPECT_EQ(dog.Start(mtn),
            "header, offset 0: a motion file begins with 'OMTN', this one does not");
  EXPECT_FALSE(dog.PlayVector());
  EXPECT_TRUE(dog.said.empty());
}

TEST(MoverCoreTest, AMotionForAnotherRobotIsRefused) {
  StandingDog dog;
  EXPECT_EQ(dog.Start(MtnBytes::OneJoint("PRM:/r1/c1-Joint2:11", {0, 10})),
            "section 2, offset 86: joint 0: the ERS-210 has no joint 'PRM:/r1/c1-Joint2:11'");
}

TEST(MoverCoreTest, AMotionDuringAMotionIsRefused) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {0, 100000}, 100)), "");
  EXPECT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {0, 10})), "JointMover is in state mtn");
}

// Whoever asked for it must not wait for its end for ever, and the motion being played goes on.
TEST(MoverCoreTest, ARefusedMotionIsReportedOverWhileTheOtherGoesOn) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {0, 100000}, 100)), "");
  MoverCommand other = {moverkindPLAY, 0, 0, {1}, 0, "OTHER.MTN", {}};
  dog.core.ReportRefusal(other);
  EXPECT_STREQ(dog.reports.back().file, "OTHER.MTN");
  EXPECT_EQ(dog.reports.back().isOver, 1);
  EXPECT_EQ(dog.reports.back().state, moverMTN);
  EXPECT_EQ(dog.reports.back().keyFrame, 0);
}

TEST(MoverCoreTest, StopEndsAMotionWhereItIs) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {0, -700000}, 100)), "");
  dog.Play(3);
  dog.core.Stop();
  EXPECT_EQ(dog.said.back(), "accepting-commands");
  EXPECT_EQ(dog.reports.back().keyFrame, -1);
  dog.Play();
  EXPECT_LT(dog.angle[dog.Joint(kTilt)], -100000);
  EXPECT_GT(dog.angle[dog.Joint(kTilt)], -400000);
}

TEST(MoverCoreTest, StopDuringPreparationBrakesWithinTheAcceleration) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kLfJ1, {1800000, 0})), "");
  dog.Play(25);
  dog.core.Stop();
  dog.Play();
  int32_t last =
      dog.frames[0][dog.Joint(kLfJ1)] + kDeg10;  // the dog stands with this joint at -10 degrees
  for (size_t f = 1; f < dog.frames.size(); ++f) {
    const int32_t step = dog.frames[f][dog.Joint(kLfJ1)] - dog.frames[f - 1][dog.Joint(kLfJ1)];
    ASSERT_LE(std::abs(step - last), 60) << f;  // 48.83 degree/s^2 are 54.5 urad per frame^2
    last = step;
  }
}

TEST(MoverCoreTest, StopWithoutAMotionDoesNothing) {
  StandingDog dog;
  dog.core.Stop();
  EXPECT_TRUE(dog.said.empty());
}

// Vectors of the old motion are still under way when the new one begins; that they end must
// not be taken for the end of the new one.
TEST(MoverCoreTest, AMotionStartedRightAfterAStopIsPlayedWhole) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {0, 100}, 100)), "");
  dog.Play(2);
  dog.core.Stop();
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {-800000, -500000, -600000})), "");
  dog.Play();
  EXPECT_EQ(dog.angle[dog.Joint(kTilt)], -600000);
  EXPECT_EQ(dog.said.back(), "accepting-commands");
}

TEST(MoverCoreTest, AJointOutsideTheMotionCanBeMovedDuringIt) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {0, 100000}, 100)), "");
  dog.Move(kTail, kDeg10);
  dog.PlayUntil(moverACCEPTING_COMMANDS);
  EXPECT_EQ(dog.angle[dog.Joint(kTail)], kDeg10);
}

TEST(MoverCoreTest, AMovingTailDoesNotKeepPreparationFromEnding) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kLfJ1, {1000000, 900000})), "");
  for (int i = 0; i < 300 && dog.core.State() == moverPREPARE_MTN; ++i) {
    dog.Move(kTail, i % 20 < 10 ? kDeg10 : -kDeg10);
    dog.PlayVector();
  }
  EXPECT_EQ(dog.core.State(), moverMTN);
}

TEST(MoverCoreTest, APositionForAJointOfTheMotionTakesEffectAfterIt) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kTilt, {0, 100000}, 10)), "");
  dog.Move(kTilt, -kDeg10);
  dog.PlayUntil(moverACCEPTING_COMMANDS);
  EXPECT_EQ(dog.angle[dog.Joint(kTilt)], 100000);
  dog.Play();
  EXPECT_EQ(dog.angle[dog.Joint(kTilt)], -kDeg10);
}

TEST(MoverCoreBatchTest, OnlyWhatDiffersFromTheBufferBeforeIsDone) {
  StandingDog dog;
  BatchMoverCommand batch = dog.Buffer();
  batch.joint[dog.Joint(kTilt)].position = -kDeg10;
  batch.joint[dog.Joint(kTilt)].flags = batchPOSITION_GIVEN;
  dog.core.Batch(batch);
  dog.Play();
  EXPECT_EQ(dog.angle[dog.Joint(kTilt)], -kDeg10);
  dog.Move(kTilt, 0);  // the remote control comes later and wins
  dog.Play();
  batch.joint[dog.Joint(kTail)].position = kDeg10;
  batch.joint[dog.Joint(kTail)].flags = batchPOSITION_GIVEN;
  dog.core.Batch(batch);
  dog.Play();
  EXPECT_EQ(dog.angle[dog.Joint(kTilt)], 0);
  EXPECT_EQ(dog.angle[dog.Joint(kTail)], kDeg10);
}

TEST(MoverCoreBatchTest, ABufferWithoutPositionsMovesNothing) {
  StandingDog dog;
  dog.core.Batch(dog.Buffer());
  EXPECT_FALSE(dog.PlayVector());
}

TEST(MoverCoreBatchTest, MotorOffTakesTheGainAwayAndRemoteCommandsHaveNoEffect) {
  StandingDog dog;
  BatchMoverCommand batch = dog.Buffer();
  const int tilt = dog.Joint(kTilt);
  batch.joint[tilt].flags = batchMOTOR_OFF;
  dog.core.Batch(batch);
  EXPECT_FALSE(dog.gain[tilt]);
  dog.Move(kTilt, -kDeg10);
  EXPECT_FALSE(dog.PlayVector());
  EXPECT_FALSE(dog.gain[tilt]);
}

TEST(MoverCoreBatchTest, APositionWakesTheJointFromWhereItHangs) {
  StandingDog dog;
  const int tilt = dog.Joint(kTilt);
  BatchMoverCommand batch = dog.Buffer();
  batch.joint[tilt].flags = batchMOTOR_OFF;
  dog.core.Batch(batch);
  dog.angle[tilt] = -600000;  // hanging
  batch.joint[tilt].flags = batchPOSITION_GIVEN;
  batch.joint[tilt].position = -kDeg10;
  dog.core.Batch(batch);
  EXPECT_FALSE(dog.gain[tilt]) << "gain on before the set point is where the joint hangs";
  dog.PlayVector();
  EXPECT_TRUE(dog.gain[tilt]);
  EXPECT_EQ(dog.frames.back()[tilt], -600000);
  dog.Play();
  EXPECT_EQ(dog.angle[tilt], -kDeg10);
  for (size_t f = 1; f < dog.frames.size(); ++f) {
    ASSERT_LE(std::abs(dog.frames[f][tilt] - dog.frames[f - 1][tilt]), 16850)
        << "jerk in frame " << f;
  }
}

TEST(MoverCoreBatchTest, TheSamePositionAsBeforeWakesTheJoint) {
  StandingDog dog;
  const int tilt = dog.Joint(kTilt);
  BatchMoverCommand batch = dog.Buffer();
  batch.joint[tilt].flags = batchPOSITION_GIVEN;
  batch.joint[tilt].position = -kDeg10;
  dog.core.Batch(batch);
  dog.Play();
  batch.joint[tilt].flags = batchPOSITION_GIVEN | batchMOTOR_OFF;
  dog.core.Batch(batch);
  dog.angle[tilt] = 0;
  batch.joint[tilt].flags = batchPOSITION_GIVEN;
  dog.core.Batch(batch);
  dog.Play();
  EXPECT_EQ(dog.angle[tilt], -kDeg10);
}

}  // namespace
}  // namespace openr_host
