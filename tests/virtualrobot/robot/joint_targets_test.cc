// Tests of the input "target", which gives servos their set points.
#include "virtualrobot/robot/joint_targets.h"

#include "tests/virtualrobot/comm_fixture.h"

namespace openr_host {
namespace {

class JointTargetsTest : public VirtualRobotCommTest {
 protected:
  JointTargetsTest() { Boot(); }

  void Add(const std::string& line) { EXPECT_EQ(system.inputs().Add(dog, line), "") << line; }
  // Returns the error in `line` without the usage that follows each of them.
  std::string ErrorIn(const std::string& line) {
    const std::string error = system.inputs().Check(dog, line);
    return error.substr(0, error.find("; usage: target JOINT"));
  }
  double SetPoint(const std::string& joint) const {
    const auto index = static_cast<size_t>(model.JointNamed(joint));
    return static_cast<double>(devices().joints[index].target_urad) * 180e-6 / 3.14159265358979;
  }
  // Returns the set point, in degrees, in each of the next `count` frames.
  std::vector<double> SetPoints(const std::string& joint, int count) {
    std::vector<double> degrees;
    for (int i = 0; i < count; ++i) {
      system.RunFor(kFrameUs);
      degrees.push_back(std::round(SetPoint(joint) * 1000) / 1000);
    }
    return degrees;
  }
};

TEST_F(JointTargetsTest, ASetPointMovesToItsGoalInEqualSteps) {
  Add("target neck_pan 20 in 32ms");
  EXPECT_EQ(SetPoints("neck_pan", 6), (std::vector<double>{5, 10, 15, 20, 20, 20}));
}

// A program that steps through a run, such as one in Python, gives its inputs when the messages of
// a frame boundary are done; other inputs come before these messages.
TEST_F(JointTargetsTest, AnInputAfterTheFrameHasBegunTakesAsManyFrames) {
  RunToFrame(2);
  Add("target neck_pan 20 in 32ms");
  system.RunFor(1);
  EXPECT_NEAR(SetPoint("neck_pan"), 5, 1e-3) << "the first step, for the frame that has begun";
  EXPECT_EQ(SetPoints("neck_pan", 5), (std::vector<double>{10, 15, 20, 20, 20}));
}

// A robot for tests that need several.
class OneRobot : public JointTargetsTest {
 public:
  uint64_t StateAfter(const std::string& input) {
    Add(input);
    SetPoints("neck_pan", 1);
    return system.state_hash();
  }

 private:
  void TestBody() override {}
};

TEST(JointTargetsStateTest, TheStateHashHasTheTimeOfAMovement) {
  const uint64_t state = OneRobot().StateAfter("target neck_pan 0 in 32ms");
  EXPECT_EQ(OneRobot().StateAfter("target neck_pan 0 in 32ms"), state);
  EXPECT_NE(OneRobot().StateAfter("target neck_pan 0 in 40ms"), state);
}

TEST_F(JointTargetsTest, WithoutADurationTheGoalIsReachedInOneFrame) {
  Add("target neck_pan -20");
  EXPECT_EQ(SetPoints("neck_pan", 2), (std::vector<double>{-20, -20}));
}

TEST_F(JointTargetsTest, AGoalInDegreesIsReachedToTheMicroradian) {
  Add("target neck_pan 60");
  SetPoints("neck_pan", 1);
  EXPECT_EQ(devices().joints[static_cast<size_t>(model.JointNamed("neck_pan"))].target_urad,
            1'047'198);
}

TEST_F(JointTargetsTest, ABegunFrameCountsAsAWholeOne) {
  Add("target neck_pan 20 in 9ms");
  EXPECT_EQ(SetPoints("neck_pan", 3), (std::vector<double>{10, 20, 20}));
  Add("target neck_pan 0 in 8ms");
  EXPECT_EQ(SetPoints("neck_pan", 1), std::vector<double>{0});
  Add("target neck_pan 10 in 0ms");
  EXPECT_EQ(SetPoints("neck_pan", 1), std::vector<double>{10});
}

TEST_F(JointTargetsTest, SeveralJointsMoveTogether) {
  Add("target  neck_pan 20   LF_j1 -10 in 16ms");
  system.RunFor(kFrameUs);
  EXPECT_NEAR(SetPoint("neck_pan"), 10, 1e-3);
  EXPECT_NEAR(SetPoint("LF_j1"), -5, 1e-3);
  system.RunFor(kFrameUs);
  EXPECT_NEAR(SetPoint("neck_pan"), 20, 1e-3);
  EXPECT_NEAR(SetPoint("LF_j1"), -10, 1e-3);
}

TEST_F(JointTargetsTest, TheFirstMovementBeginsAtTheMeasuredAngleTheNextAtTheSetPoint) {
  Angle(kPan) = Radians(40);
  Add("target neck_pan 20 in 16ms");
  EXPECT_EQ(SetPoints("neck_pan", 2), (std::vector<double>{30, 20}));
  Angle(kPan) = Radians(40);
  Add("target neck_pan 0 in 16ms");
  EXPECT_EQ(SetPoints("neck_pan", 2), (std::vector<double>{10, 0}));
}

TEST_F(JointTargetsTest, ANewTargetReplacesTheOneThatIsUnderWay) {
  Add("target neck_pan 40 in 32ms");
  EXPECT_EQ(SetPoints("neck_pan", 2), (std::vector<double>{10, 20}));
  Add("target neck_pan 0 in 16ms");
  EXPECT_EQ(SetPoints("neck_pan", 3), (std::vector<double>{10, 0, 0}));
}

TEST_F(JointTargetsTest, OffAndReleaseStopTheMovement) {
  Add("target neck_pan 40 in 32ms");
  EXPECT_EQ(SetPoints("neck_pan", 1), std::vector<double>{10});
  Add("target off");
  EXPECT_EQ(SetPoints("neck_pan", 2), (std::vector<double>{10, 10}));
  Add("target neck_pan 20 neck_tilt 40 in 16ms");
  EXPECT_EQ(SetPoints("neck_pan", 1), std::vector<double>{15});
  Add("release neck_pan");
  EXPECT_EQ(SetPoints("neck_pan", 2), (std::vector<double>{15, 15}));
  EXPECT_NEAR(SetPoint("neck_tilt"), 40, 1e-3) << "the other joint goes on";
}

TEST_F(JointTargetsTest, TheInputWinsOverAProgramUntilTheJointIsReleased) {
  OPrimitiveID pan = 0;
  As([&] { pan = mover->Open(kPan); });
  const auto send = [&](int urad) {
    As([&] {
      RCRegion* const region = mover->NewVector(1);
      Mover::FillJoint(region, 0, pan, std::vector<int>(4, urad));
      mover->Send({region});
    });
    system.RunFor(8 * kFrameUs);
  };
  Add("target neck_pan 20");
  send(100'000);
  EXPECT_NEAR(SetPoint("neck_pan"), 20, 1e-3);
  Add("target off");
  send(200'000);
  EXPECT_EQ(Pan(), 200'000);
}

TEST_F(JointTargetsTest, MistakesAreNamed) {
  EXPECT_EQ(ErrorIn("target"), "target: needs joints, each with an angle in degrees");
  EXPECT_EQ(ErrorIn("target neck_pan"), "target: needs joints, each with an angle in degrees");
  EXPECT_EQ(ErrorIn("target in 8ms"), "target: needs joints, each with an angle in degrees");
  EXPECT_EQ(ErrorIn("target neck_pan x"), "target: 'x' is no number");
  EXPECT_EQ(ErrorIn("target neck_pan 20 in x"), ErrorIn("target neck_tilt 20 in x"));
  EXPECT_NE(ErrorIn("target neck_pan 20 in x"), "");
  EXPECT_EQ(ErrorIn("target neck_pan 92.7"),
            "target: 92.7 degrees is beyond the stops of neck_pan, -92.6 to 92.6");
  EXPECT_EQ(ErrorIn("target neck_pan -92.7"),
            "target: -92.7 degrees is beyond the stops of neck_pan, -92.6 to 92.6");
  EXPECT_EQ(ErrorIn("target neck_pan 92.6 neck_tilt -85"), "");
  EXPECT_EQ(ErrorIn("target neck_pam 1")
                .find("target: the ERS-210 has no joint 'neck_pam'; did you mean 'neck_pan'?; it "
                      "has neck_tilt"),
            0u)
      << ErrorIn("target neck_pam 1");
}

}  // namespace
}  // namespace openr_host
