// Motors and gains in JointMover's logic: MOTOR_OFF, MOTOR_ON and GAINS of the remote control.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "mover_dog.h"

namespace openr_host {
namespace {

constexpr char kTiltJoint[] = "PRM:/r1/c1-Joint2:j1";

class MoverMotorsTest : public testing::Test {
 protected:
  void Switch(int kind, int joint) {
    MoverCommand command = {kind, joint, 0, {0}, 0, {}, {}};
    dog_.core.CarryOut(command);
  }
  int NumLimp() const {
    int count = 0;
    for (const auto& [joint, on] : dog_.gain) count += on ? 0 : 1;
    return count;
  }

  StandingDog dog_;
  const int tilt_ = dog_.Joint(kTiltJoint);
};

TEST_F(MoverMotorsTest, AllMotorsLosePowerAndEveryGainIsOff) {
  Switch(moverkindMOTOR_OFF, MOVER_ALL_JOINTS);
  EXPECT_FALSE(dog_.motor_power);
  EXPECT_EQ(NumLimp(), dog_.robot->numJoints);
  ASSERT_EQ(dog_.reports.size(), 1u);
  EXPECT_EQ(dog_.reports[0].motorsOff, 1);
  EXPECT_EQ(dog_.reports[0].state, moverACCEPTING_COMMANDS);
}

// Sends TRACK to the tilt joint and plays what follows; returns the positions of all frames.
std::vector<int32_t> Tracked(StandingDog* dog, int32_t urad, int frames) {
  const int tilt = dog->Joint(kTiltJoint);
  dog->core.CarryOut({moverkindTRACK, tilt, urad, {frames}, 0, {}, {}});
  const size_t begin = dog->frames.size();
  dog->Play();
  std::vector<int32_t> positions;
  for (size_t i = begin; i < dog->frames.size(); ++i) positions.push_back(dog->frames[i].at(tilt));
  return positions;
}

TEST_F(MoverMotorsTest, TrackReachesItsGoalInItsFramesWhateverTheLimits) {
  dog_.Command(moverkindSPEED, kTiltJoint, 1);
  dog_.Command(moverkindACCELERATION, kTiltJoint, 1);
  const std::vector<int32_t> way = Tracked(&dog_, dog_.angle[tilt_] - 400000, 4);
  ASSERT_GE(way.size(), 4u);
  EXPECT_EQ(way[3], way.back());
  EXPECT_EQ(way[1] - way[0], way[3] - way[2]);
}

TEST_F(MoverMotorsTest, TrackGoesFarAwayWithinTheLimits) {
  const std::vector<int32_t> way = Tracked(&dog_, dog_.angle[tilt_] - 800000, 1);
  EXPECT_GT(way.size(), 40u);
}

TEST_F(MoverMotorsTest, TrackDoesNotMoveAJointThatIsOff) {
  Switch(moverkindMOTOR_OFF, tilt_);
  EXPECT_TRUE(Tracked(&dog_, dog_.angle[tilt_] - 400000, 4).empty());
}

TEST_F(MoverMotorsTest, OnlyMotorOnBringsPowerBack) {
  Switch(moverkindMOTOR_OFF, MOVER_ALL_JOINTS);
  dog_.Move(kTiltJoint, -300000);
  dog_.Command(moverkindSPEED, kTiltJoint, 5000);
  dog_.Command(moverkindACCELERATION, kTiltJoint, 5000);
  BatchMoverCommand buffer = dog_.Buffer();
  buffer.joint[tilt_].position = -300000;
  buffer.joint[tilt_].flags = batchPOSITION_GIVEN;
  dog_.core.Batch(buffer);
  EXPECT_EQ(dog_.Start(MtnBytes::OneJoint(kTiltJoint, {0, 10000})), "motor power is off");
  Switch(moverkindMOTOR_ON, tilt_);
  dog_.Play();
  EXPECT_FALSE(dog_.motor_power);
  EXPECT_EQ(NumLimp(), dog_.robot->numJoints);
  EXPECT_TRUE(dog_.frames.empty()) << "no vector is sent to joints without power";
}

TEST_F(MoverMotorsTest, JointsThatAreSwitchedOnStayWhereTheyHang) {
  Switch(moverkindMOTOR_OFF, MOVER_ALL_JOINTS);
  dog_.angle[tilt_] = -200000;  // moved by hand
  Switch(moverkindMOTOR_ON, MOVER_ALL_JOINTS);
  EXPECT_TRUE(dog_.motor_power);
  EXPECT_EQ(NumLimp(), dog_.robot->numJoints) << "the gains follow after a vector";
  EXPECT_EQ(dog_.reports.back().motorsOff, 0);
  dog_.Play();
  EXPECT_EQ(NumLimp(), 0);
  ASSERT_FALSE(dog_.frames.empty());
  for (const auto& frame : dog_.frames) EXPECT_EQ(frame.at(tilt_), -200000);
  dog_.Move(kTiltJoint, -300000);
  dog_.Play();
  EXPECT_EQ(dog_.angle[tilt_], -300000);
}

TEST_F(MoverMotorsTest, AJointThatHasHardlyMovedIsHeldWhereItWas) {
  const int32_t before = dog_.angle[tilt_];
  Switch(moverkindMOTOR_OFF, MOVER_ALL_JOINTS);
  dog_.angle[tilt_] = before - 1700;
  Switch(moverkindMOTOR_ON, MOVER_ALL_JOINTS);
  dog_.Play();
  EXPECT_EQ(dog_.angle[tilt_], before);
  Switch(moverkindMOTOR_OFF, MOVER_ALL_JOINTS);
  dog_.angle[tilt_] = before - 1800;
  Switch(moverkindMOTOR_ON, MOVER_ALL_JOINTS);
  dog_.Play();
  EXPECT_EQ(dog_.angle[tilt_], before - 1800);
}

TEST_F(MoverMotorsTest, AMotionEndsWhenPowerIsSwitchedOff) {
  ASSERT_EQ(dog_.Start(MtnBytes::OneJoint(kTiltJoint, {0, 10000, 20000, 30000, 40000, 50000})), "");
  dog_.PlayVector();
  Switch(moverkindMOTOR_OFF, MOVER_ALL_JOINTS);
  EXPECT_EQ(dog_.core.State(), moverACCEPTING_COMMANDS);
  EXPECT_EQ(dog_.reports.back().keyFrame, -1);
  EXPECT_EQ(dog_.reports.back().motorsOff, 1);
  const size_t frames = dog_.frames.size();
  dog_.Play();
  EXPECT_LE(dog_.frames.size(), frames + 16) << "only vectors that were sent before";
}

TEST_F(MoverMotorsTest, OneJointIsLimpWhileTheOthersGoOn) {
  const int pan = dog_.Joint("PRM:/r1/c1/c2-Joint2:j2");
  Switch(moverkindMOTOR_OFF, tilt_);
  EXPECT_TRUE(dog_.motor_power);
  EXPECT_EQ(NumLimp(), 1);
  EXPECT_TRUE(dog_.reports.empty());
  dog_.Move(kTiltJoint, -300000);
  dog_.Move("PRM:/r1/c1/c2-Joint2:j2", 100000);
  dog_.Play();
  EXPECT_EQ(dog_.angle[pan], 100000);
  EXPECT_NE(dog_.angle[tilt_], -300000);
  Switch(moverkindMOTOR_ON, tilt_);
  dog_.Play();
  EXPECT_EQ(NumLimp(), 0);
}

TEST_F(MoverMotorsTest, AJointSwitchedOnDuringAMotionWakesBehindIt) {
  Switch(moverkindMOTOR_OFF, tilt_);
  ASSERT_EQ(dog_.Start(MtnBytes::OneJoint(kTiltJoint, {0, 10000, 20000, 30000})), "");
  const int32_t hangs = dog_.angle[tilt_];
  Switch(moverkindMOTOR_ON, tilt_);
  EXPECT_FALSE(dog_.gain[tilt_]);
  dog_.Play();
  EXPECT_TRUE(dog_.gain[tilt_]);
  EXPECT_EQ(dog_.angle[tilt_], hangs);
}

// Returns the largest step of a set point of joint `joint` from one frame to the next.
int32_t LargestStep(const StandingDog& dog, int joint) {
  int32_t largest = 0;
  for (size_t f = 1; f < dog.frames.size(); ++f)
    largest = std::max(largest, std::abs(dog.frames[f].at(joint) - dog.frames[f - 1].at(joint)));
  return largest;
}

// Switches all joints of `dog` off and on again, and then starts a motion of the joint `tilt`,
// which hangs at `hangs` micro-radians meanwhile.  If `is_vector_made`, a vector is made between
// both.
void StartAfterMotorOn(StandingDog* dog, int tilt, int32_t hangs, bool is_vector_made) {
  dog->core.CarryOut({moverkindMOTOR_OFF, MOVER_ALL_JOINTS, 0, {0}, 0, {}, {}});
  dog->angle[tilt] = hangs;
  dog->core.CarryOut({moverkindMOTOR_ON, MOVER_ALL_JOINTS, 0, {0}, 0, {}, {}});
  VectorPlan plan;
  if (is_vector_made) {
    ASSERT_TRUE(dog->core.NextVector(&plan));
    dog->under_way.push_back(plan);
  }
  ASSERT_EQ(dog->Start(MtnBytes::OneJoint(kTiltJoint, {0, 1000, 2000})), "");
}

// The gain comes with the end of a vector, and only then the joint can move to the first key frame.
TEST_F(MoverMotorsTest, AMotionRightAfterMotorOnWaitsUntilTheJointsAreAtItsFirstKeyFrame) {
  for (const bool is_vector_made : {false, true}) {
    StandingDog dog;
    StartAfterMotorOn(&dog, tilt_, -1000000, is_vector_made);  // far from the first key frame
    EXPECT_EQ(dog.core.State(), moverPREPARE_MTN) << is_vector_made;
    dog.Play();
    EXPECT_EQ(dog.core.State(), moverACCEPTING_COMMANDS);
    EXPECT_EQ(dog.angle[tilt_], 2000);
    EXPECT_EQ(dog.frames.front().at(tilt_), -1000000);
    EXPECT_LT(LargestStep(dog, tilt_), 50000) << "2.9 degrees, more than any joint's speed limit";
  }
}

TEST_F(MoverMotorsTest, AMotionRightAfterMotorOnWaitsForTheGainsOfNearJoints) {
  for (const int32_t hangs : {-200000, 0}) {
    for (const bool is_vector_made : {false, true}) {
      StandingDog dog;
      StartAfterMotorOn(&dog, tilt_, hangs, is_vector_made);
      EXPECT_EQ(dog.core.State(), moverPREPARE_MTN) << hangs << is_vector_made;
      while (!dog.gain[tilt_]) ASSERT_TRUE(dog.PlayVector());
      for (const auto& frame : dog.frames) EXPECT_EQ(frame.at(tilt_), hangs);
      dog.Play();
      EXPECT_EQ(dog.core.State(), moverACCEPTING_COMMANDS);
      EXPECT_EQ(dog.angle[tilt_], 2000) << "the joint does not go back to where it hung";
      EXPECT_LT(LargestStep(dog, tilt_), 50000);
    }
  }
}

TEST_F(MoverMotorsTest, AJointThatWaitsForItsGainDoesNotMoveAfterAStop) {
  Switch(moverkindMOTOR_OFF, MOVER_ALL_JOINTS);
  dog_.angle[tilt_] = -1000000;
  Switch(moverkindMOTOR_ON, MOVER_ALL_JOINTS);
  ASSERT_EQ(dog_.Start(MtnBytes::OneJoint(kTiltJoint, {0, 1000, 2000})), "");
  dog_.core.Stop();
  dog_.Play();
  EXPECT_TRUE(dog_.gain[tilt_]);
  EXPECT_EQ(dog_.angle[tilt_], -1000000);
}

// Nothing else moves, so no further vector would end the way to the first key frame.
TEST_F(MoverMotorsTest, AJointSwitchedOffOnTheWayToTheFirstKeyFrameKeepsNoMotionWaiting) {
  ASSERT_EQ(dog_.Start(MtnBytes::OneJoint(kTiltJoint, {-1000000, -900000})), "");
  dog_.Play(10);
  ASSERT_EQ(dog_.core.State(), moverPREPARE_MTN);
  Switch(moverkindMOTOR_OFF, tilt_);
  dog_.Play();
  EXPECT_EQ(dog_.core.State(), moverACCEPTING_COMMANDS);
  EXPECT_EQ(dog_.said, (std::vector<std::string>{"prepare-mtn", "mtn", "accepting-commands"}));
  EXPECT_EQ(dog_.reports.back().isOver, 1);
}

TEST_F(MoverMotorsTest, AllMotorsOnWhileTheyAreOnIsNoReport) {
  Switch(moverkindMOTOR_ON, MOVER_ALL_JOINTS);
  EXPECT_TRUE(dog_.reports.empty());
  EXPECT_EQ(NumLimp(), 0);
}

TEST_F(MoverMotorsTest, GainsTheRobotBeginsWithAreThoseOfItsTable) {
  EXPECT_EQ(dog_.gains[dog_.Joint("PRM:/r2/c1-Joint2:j1")], (std::vector<int>{22, 4, 8}));
}

TEST_F(MoverMotorsTest, GainsAreSetAtOnceOrWhenTheJointIsSwitchedOn) {
  MoverCommand command = {moverkindGAINS, tilt_, 0, {0}, 0, {}, {30, 0, 5}};
  dog_.core.CarryOut(command);
  EXPECT_EQ(dog_.gains[tilt_], (std::vector<int>{30, 0, 5}));
  Switch(moverkindMOTOR_OFF, tilt_);
  command.gain[0] = 31;
  dog_.core.CarryOut(command);
  EXPECT_FALSE(dog_.gain[tilt_]);
  EXPECT_EQ(dog_.gains[tilt_], (std::vector<int>{30, 0, 5}));
  Switch(moverkindMOTOR_ON, tilt_);
  dog_.Play();
  EXPECT_EQ(dog_.gains[tilt_], (std::vector<int>{31, 0, 5}));
}

TEST_F(MoverMotorsTest, CommandsBeforeTheRobotStandsAndForNoJointHaveNoEffect) {
  Dog dog;
  for (const int kind : {moverkindMOTOR_OFF, moverkindMOTOR_ON, moverkindGAINS}) {
    for (const int joint : {-1, 0, 18, 1000000}) {
      MoverCommand command = {kind, joint, 0, {0}, 0, {}, {99, 99, 99}};
      dog.core.CarryOut(command);
      if (joint > 17) dog_.core.CarryOut(command);
    }
  }
  EXPECT_TRUE(dog.motor_power);
  EXPECT_TRUE(dog.gains.empty());
  EXPECT_EQ(NumLimp(), 0);
}

}  // namespace
}  // namespace openr_host
