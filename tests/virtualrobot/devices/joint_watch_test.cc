// Findings about joints: robot.md 8, field-notes.md 7.
#include <gtest/gtest.h>

#include "tests/virtualrobot/comm_fixture.h"

namespace openr_host {
namespace {

class JointWatchTest : public VirtualRobotCommTest {
 protected:
  using VirtualRobotCommTest::VirtualRobotCommTest;
  void SetUp() override {
    Angle(kPan) = 0.5;
    Boot();
    As([&] { pan = mover->Open(kPan); });
  }
  void Command(const std::vector<int>& urad) {
    As([&] {
      RCRegion* region = mover->NewVector(1);
      Mover::FillJoint(region, 0, pan, urad);
      mover->Send({region});
    });
    RunToFrame(robot->frame() + static_cast<int64_t>(urad.size()) + 2);
  }
  void SetGain() {
    EXPECT_EQ(OPENR::EnableJointGain(pan), oSUCCESS);
    EXPECT_EQ(OPENR::SetJointGain(pan, 13, 8, 11, 14, 2, 15), oSUCCESS);
  }
  OPrimitiveID pan = 0;
};

// Open, power, hold where it is, gains, move: the order of every sample.
TEST_F(JointWatchTest, TheStandardOpeningGivesNoFinding) {
  As([&] { OPENR::SetMotorPower(opowerON); });
  Command({500'000, 500'000});
  As([&] { SetGain(); });
  Command({510'000, 520'000, 530'000});
  EXPECT_EQ(Findings(), "");
}

TEST_F(JointWatchTest, GainsWithoutASetPoint) {
  As([&] {
    OPENR::SetMotorPower(opowerON);
    OPENR::EnableJointGain(pan);
  });
  EXPECT_EQ(Findings(), "");  // no gain acts yet
  As([&] { OPENR::SetJointGain(pan, 13, 8, 11, 14, 2, 15); });
  EXPECT_EQ(Findings(),
            "mover: PRM:/r1/c1/c2-Joint2:j2: its gains take effect before any set point was sent; "
            "the joint is at 28.6 degrees and goes to 0.0 at full power (send a vector with the "
            "position of GetJointValue() first)\n");
}

TEST_F(JointWatchTest, MotorPowerAfterGainsWithoutASetPoint) {
  As([&] { SetGain(); });
  EXPECT_EQ(Findings(), "");
  As([&] { OPENR::SetMotorPower(opowerON); });
  EXPECT_EQ(CountFindings("its gains take effect before any set point was sent"), 1);
}

TEST_F(JointWatchTest, JumpAtStart) {
  Command({0});
  As([&] {
    OPENR::SetMotorPower(opowerON);
    SetGain();
  });
  EXPECT_EQ(CountFindings("its gains take effect far from its set point; the joint is at 28.6 "
                          "degrees and goes to 0.0"),
            1);
}

// field-notes.md 7.10: the program takes the set point of the joint for its position.
TEST_F(JointWatchTest, TheRefValueOfAJointThatNobodyCommandedIsNotItsPosition) {
  OJointValue value;
  As([&] { EXPECT_EQ(OPENR::GetJointValue(pan, &value), oSUCCESS); });
  EXPECT_EQ(value.value, 500'000);
  EXPECT_EQ(value.refValue, 0);
  Command({value.refValue});
  As([&] {
    OPENR::SetMotorPower(opowerON);
    SetGain();
  });
  EXPECT_EQ(CountFindings("its gains take effect far from its set point; the joint is at 28.6 "
                          "degrees and goes to 0.0"),
            1);
}

// A joint that was commanded to its position sinks while it is limp, before the gains are set. That
// is the effect of its weight and no mistake of the program.
TEST_F(JointWatchTest, AJointThatSinksDuringTheOpeningIsNoFinding) {
  As([&] { OPENR::SetMotorPower(opowerON); });
  Command({500'000});
  Angle(kPan) = 0.5 - 0.47;  // 27 degrees
  Command(std::vector<int>(16, 500'000));
  As([&] { SetGain(); });
  EXPECT_EQ(Findings(), "");
}

// The joint may also sink before the first vector comes.
TEST_F(JointWatchTest, AJointThatSankBeforeItsFirstSetPointIsNoFinding) {
  As([&] { OPENR::SetMotorPower(opowerON); });
  RunToFrame(17);
  Angle(kPan) = 0.5 - 0.47;
  RunToFrame(19);
  Command({500'000});
  As([&] { SetGain(); });
  EXPECT_EQ(Findings(), "");
}

// A position counts for a second only; later the joint is far from its set point.
TEST_F(JointWatchTest, WhereAJointWasASecondAgoIsNoPardon) {
  As([&] { OPENR::SetMotorPower(opowerON); });
  Command({500'000});
  Angle(kPan) = 0;
  RunToFrame(robot->frame() + 130);
  As([&] { SetGain(); });
  EXPECT_EQ(CountFindings("its gains take effect far from its set point; the joint is at 0.0 "
                          "degrees and goes to 28.6"),
            1);
}

// The joint falls while motor power is off, and jumps when power comes back.
TEST_F(JointWatchTest, AServoThatHasActedIsNotPardoned) {
  As([&] { OPENR::SetMotorPower(opowerON); });
  Command({500'000});
  As([&] { SetGain(); });
  As([&] { OPENR::SetMotorPower(opowerOFF); });
  Angle(kPan) = 0;
  As([&] { OPENR::SetMotorPower(opowerON); });
  EXPECT_EQ(CountFindings("its gains take effect far from its set point"), 1);
}

TEST_F(JointWatchTest, AMoveBeforeTheGainsIsNotPardoned) {
  As([&] { OPENR::SetMotorPower(opowerON); });
  Command({500'000});
  Command({0});
  As([&] { SetGain(); });
  EXPECT_EQ(CountFindings("its gains take effect far from its set point"), 1);
  EXPECT_EQ(CountFindings("set points without effect: no gain"), 1);
}

TEST_F(JointWatchTest, JumpOnTheWay) {
  As([&] { OPENR::SetMotorPower(opowerON); });
  Command({500'000});
  As([&] { SetGain(); });
  Command({500'000, -500'000, 500'000});
  EXPECT_EQ(CountFindings("set point jumps from 28.6 to -28.6 degrees in one frame"), 1);
  EXPECT_EQ(system.findings().all().size(), 1u);  // once per joint
}

TEST_F(JointWatchTest, CommandsWithoutMotorPower) {
  As([&] { SetGain(); });
  Command({0});
  EXPECT_EQ(Findings(),
            "mover: set points without effect: motor power is off "
            "(OPENR::SetMotorPower(opowerON)): PRM:/r1/c1/c2-Joint2:j2\n");
}

TEST_F(JointWatchTest, CommandsWithoutGain) {
  As([&] { OPENR::SetMotorPower(opowerON); });
  Command({0});
  EXPECT_EQ(CountFindings("set points without effect: no gain"), 1);
}

TEST_F(JointWatchTest, AProgramThatThePauseButtonStoppedIsNotToBlame) {
  As([&] { OPENR::SetMotorPower(opowerON); });
  Command({500'000});
  As([&] { SetGain(); });
  robot->PressPause();
  Command({100'000});
  EXPECT_EQ(Findings(), "");
}

TEST_F(JointWatchTest, RadiansForMicroRadians) {
  As([&] { OPENR::SetMotorPower(opowerON); });
  Angle(kPan) = 0;
  Command(std::vector<int>(16, 1));
  EXPECT_EQ(Findings(), "");
  Command(std::vector<int>(16, -2));
  EXPECT_EQ(CountFindings("set points within +-10 are micro-radians"), 1);
}

// 78 % of 255 for 30 s.
TEST_F(JointWatchTest, AMotorThatPushesForHalfAMinuteIsReported) {
  const auto joint = static_cast<size_t>(model.FindJointByLocator(kPan));
  body->mutable_state().joints[joint].drive = -199;
  RunToFrame(3740);
  body->mutable_state().joints[joint].drive = 198;
  RunToFrame(3741);
  body->mutable_state().joints[joint].drive = -199;
  RunToFrame(3741 + 3749);
  EXPECT_EQ(Findings(), "");
  RunToFrame(3741 + 3750);
  EXPECT_EQ(CountFindings("PPM::PWM Limit Over!! Motor:1 (PRM:/r1/c1/c2-Joint2:j2); "
                          "MECHA_LOAD_HIGH. SHUTDOWN."),
            1);
  RunToFrame(3741 + 3760);
  EXPECT_FALSE(system.powered_off());
}

TEST_F(JointWatchTest, EachOfTwoMotorsThatPushForTheSameTimeIsReported) {
  body->mutable_state().joints[0].drive = 255;
  body->mutable_state().joints[1].drive = -255;
  RunToFrame(3760);
  EXPECT_EQ(CountFindings("PPM::PWM Limit Over!! Motor:0 "), 1);
  EXPECT_EQ(CountFindings("PPM::PWM Limit Over!! Motor:1 "), 1);
}

class StrictJointWatchTest : public JointWatchTest {
 protected:
  StrictJointWatchTest() : JointWatchTest({}, "ers210", {.strict = true}) {}
};

TEST_F(StrictJointWatchTest, AndShutsTheRobotDownWhenStrict) {
  body->mutable_state().joints[0].drive = 300;
  RunToFrame(3751);
  EXPECT_TRUE(system.powered_off());
  ASSERT_TRUE(system.end());
  EXPECT_EQ(system.end()->kind, EndKind::kStrict);
}

// ---- one SHIFT for all joints of an ERS-7 (field-notes.md 7.15)

// Two joints of the head that have gains, and are held where they are.
class ShiftTest : public VirtualRobotCommTest {
 protected:
  explicit ShiftTest(const char* name = "ers7") : VirtualRobotCommTest({}, name) {}
  void SetUp() override {
    Boot();
    As([&] {
      tilt = mover->Open(model.joints[0].locator.c_str());
      pan = mover->Open(model.joints[1].locator.c_str());
      OPENR::SetMotorPower(opowerON);
    });
    Hold();
  }
  // Sends set points, as every program does all the time.
  void Hold() {
    As([&] {
      RCRegion* region = mover->NewVector(2);
      Mover::FillJoint(region, 0, tilt, {0});
      Mover::FillJoint(region, 1, pan, {0});
      mover->Send({region});
    });
    RunToFrame(robot->frame() + 3);
  }
  static void SetGain(OPrimitiveID joint, word p_shift) {
    EXPECT_EQ(OPENR::EnableJointGain(joint), oSUCCESS);
    EXPECT_EQ(OPENR::SetJointGain(joint, 10, 4, 2, p_shift, 2, 15), oSUCCESS);
  }
  static word PShiftOf(OPrimitiveID joint) {
    word p, i, d, p_shift, i_shift, d_shift;
    EXPECT_EQ(OPENR::GetJointGain(joint, &p, &i, &d, &p_shift, &i_shift, &d_shift), oSUCCESS);
    return p_shift;
  }
  OPrimitiveID tilt = 0, pan = 0;
};

TEST_F(ShiftTest, ShiftsThatDifferAreReportedAndTheLastOnesHoldForAll) {
  As([&] {
    SetGain(tilt, 14);
    SetGain(pan, 15);
    EXPECT_EQ(PShiftOf(tilt), 15);
  });
  EXPECT_EQ(Findings(), "");
  Hold();
  Hold();
  EXPECT_EQ(Findings(),
            "mover: SetJointGain: shifts 14 2 15 for PRM:/r1/c1-Joint2:11 and 15 2 15 for "
            "PRM:/r1/c1/c2-Joint2:12; this robot has one SHIFT for all joints, and the last call "
            "sets it\n");
}

TEST_F(ShiftTest, NewShiftsForAllJointsAreNoFinding) {
  As([&] {
    SetGain(tilt, 14);
    SetGain(pan, 14);
  });
  Hold();
  As([&] {
    SetGain(tilt, 15);
    SetGain(pan, 15);
  });
  Hold();
  EXPECT_EQ(Findings(), "");
}

// Gains of 0 make a joint limp; their shifts mean nothing.
TEST_F(ShiftTest, AJointWithoutGainAsksForNoShift) {
  As([&] {
    SetGain(tilt, 14);
    SetGain(pan, 14);
    EXPECT_EQ(OPENR::SetJointGain(pan, 0, 0, 0, 0, 0, 0), oSUCCESS);
    EXPECT_EQ(PShiftOf(tilt), 14);
  });
  Hold();
  EXPECT_EQ(CountFindings("SetJointGain: shifts"), 0);
}

class Ers210ShiftTest : public ShiftTest {
 protected:
  Ers210ShiftTest() : ShiftTest("ers210") {}
};

TEST_F(Ers210ShiftTest, EachJointHasItsOwnShifts) {
  As([&] {
    SetGain(tilt, 14);
    SetGain(pan, 15);
    EXPECT_EQ(PShiftOf(tilt), 14);
  });
  Hold();
  EXPECT_EQ(Findings(), "");
}

// ---- reading and closing

TEST_F(JointWatchTest, ReadingAPrimitiveThatNobodyOpenedIsReported) {
  As([&] {
    OSensorValue value;
    EXPECT_EQ(OPENR::GetSensorValue(pan - 1, &value), oSUCCESS);
    EXPECT_EQ(OPENR::GetSensorValue(12345, &value), oINVALID_PRIMITIVE_ID);
  });
  EXPECT_EQ(CountFindings("GetSensorValue(PRM:/r1/c1-Joint2:j1): nobody opened it"), 1);
}

// field-notes.md 8.7: a joint that nobody opened, and a wrong index, were the likely causes of
// wrong numbers.
TEST_F(JointWatchTest, GetJointValueOfWhatNobodyOpenedIsReportedAndOfNoJointRefused) {
  As([&] {
    OJointValue value;
    EXPECT_EQ(OPENR::GetJointValue(pan - 1, &value), oSUCCESS);
    EXPECT_EQ(OPENR::GetJointValue(pan, &value), oSUCCESS);
    EXPECT_EQ(OPENR::GetJointValue(12345, &value), oINVALID_PRIMITIVE_ID);
    const OPrimitiveID chin = mover->Open("PRM:/r1/c1/c2/c3/c4/s5-Sensor:s5");
    EXPECT_EQ(OPENR::GetJointValue(chin, &value), oINVALID_PRIMITIVE_ID);
  });
  EXPECT_EQ(Findings(),
            "mover: GetJointValue(PRM:/r1/c1-Joint2:j1): nobody opened it; on the robot its value "
            "means nothing\n");
}

TEST_F(JointWatchTest, APrimitiveIsOpenUntilEverybodyHasClosedIt) {
  As([&] {
    EXPECT_EQ(mover->Open(kPan), pan);
    EXPECT_EQ(OPENR::ClosePrimitive(pan), oSUCCESS);
    OJointValue value;
    OPENR::GetJointValue(pan, &value);
    EXPECT_EQ(Findings(), "");
    EXPECT_EQ(OPENR::ClosePrimitive(pan), oSUCCESS);
    EXPECT_EQ(OPENR::ClosePrimitive(pan), oINVALID_PRIMITIVE_ID);
    EXPECT_EQ(OPENR::ClosePrimitive(12345), oINVALID_PRIMITIVE_ID);
  });
}

}  // namespace
}  // namespace openr_host
