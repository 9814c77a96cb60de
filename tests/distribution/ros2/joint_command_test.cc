#include "openr/ros2/joint_command.h"

#include <gtest/gtest.h>

#include <limits>

#include "openr/ros2/robot_topics.h"
#include "openr/ros2/ros2_link.h"

namespace openr_host {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class JointCommandTest : public testing::Test {
 protected:
  std::string Read(const Ros2JointCommand& command) {
    return ReadJointCommand(command, model_, &targets_);
  }

  const RobotModel model_ = LoadRobotModel(OPENR_MODEL_DIR "/ers210.json");
  std::map<int, JointTarget> targets_;
};

TEST_F(JointCommandTest, TargetsAreThoseOfTheRobotsJoints) {
  EXPECT_EQ(Read({{"neck_pan", "LF_j1"}, {0.5, -1}, {}}), "");
  ASSERT_EQ(targets_.size(), 2u);
  EXPECT_EQ(targets_[model_.FindJoint("neck_pan")].position_rad, 0.5);
  EXPECT_EQ(targets_[model_.FindJoint("LF_j1")].position_rad, -1);
  EXPECT_EQ(targets_[model_.FindJoint("LF_j1")].speed_rad_s, 0);
}

TEST_F(JointCommandTest, AVelocityIsALimitWithoutSign) {
  EXPECT_EQ(Read({{"neck_pan"}, {0.5}, {-2}}), "");
  EXPECT_EQ(targets_[model_.FindJoint("neck_pan")].speed_rad_s, 2);
}

TEST_F(JointCommandTest, AnErrorIsNamed) {
  EXPECT_EQ(Read({{}, {}, {}}), "names no joint");
  EXPECT_EQ(Read({{"neck_pan"}, {kNan}, {}}), "the position of neck_pan is no number");
  EXPECT_EQ(Read({{"neck_pan"}, {-kInfinity}, {}}), "the position of neck_pan is no number");
  EXPECT_EQ(Read({{"neck_pan"}, {0}, {kInfinity}}), "the velocity of neck_pan is no number");
  EXPECT_EQ(Read({{"neck_pan", "neck_pan"}, {0, 1}, {}}), "neck_pan is named twice");
  EXPECT_EQ(Read({{"neck_pan"}, {0, 1}, {}}),
            "1 names, 2 positions, 0 velocities; a position for each name, a velocity for each or "
            "none");
  EXPECT_EQ(Read({{"neck_pan"}, {0}, {1, 2}}),
            "1 names, 1 positions, 2 velocities; a position for each name, a velocity for each or "
            "none");
  EXPECT_TRUE(targets_.empty());
}

TEST_F(JointCommandTest, ANameFromTheNetworkIsShownShortAndHarmless) {
  const std::string text = Read({{"\x1b[2J" + std::string(1000, 'x')}, {0}, {}});
  EXPECT_EQ(text.find("'?[2J" + std::string(36, 'x') + "...' is no joint of the ERS-210"), 0u)
      << text;
}

TEST(TopicPartTest, TheTopicPartIsTheSensorNameInLowerCase) {
  EXPECT_EQ(TopicPart("Paw sensor (left fore leg)"), "paw_sensor_left_fore_leg");
  EXPECT_EQ(TopicPart("Chin switch"), "chin_switch");
  EXPECT_EQ(TopicPart(" Head - 2 "), "head_2");
}

TEST(NamespaceTest, ANamespaceIsWordsWithSlashesBetween) {
  EXPECT_EQ(WrongNamespace("aibo"), "");
  EXPECT_EQ(WrongNamespace("team/aibo_2"), "");
  EXPECT_EQ(WrongNamespace(std::string(64, 'a')), "");
  EXPECT_NE(WrongNamespace(std::string(65, 'a')), "");
  EXPECT_NE(WrongNamespace("2aibo"), "");
  EXPECT_NE(WrongNamespace("a__b"), "");
}

}  // namespace
}  // namespace openr_host
