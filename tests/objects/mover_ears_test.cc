// Ears in motions: two-position joints, which JointMover reports and does not move.
#include <gtest/gtest.h>

#include "mover_dog.h"

namespace openr_host {
namespace {

constexpr const char* kNeckTilt = "PRM:/r1/c1-Joint2:j1";
constexpr const char* kRightEar = "PRM:/r1/c1/c2/c3/e2-Joint3:j6";

// "1/2": of the ears in the mask 1 those in 2 are on.
std::vector<std::string> EarsByKeyFrame(const Dog& dog) {
  std::vector<std::string> ears;
  for (const SetValueMessage& report : dog.reports) {
    ears.push_back(std::to_string(report.keyFrame) + ": " + std::to_string(report.earMask) + "/" +
                   std::to_string(report.earOn));
  }
  return ears;
}

TEST(MoverEarsTest, PlungersOfAMotionAreReportedWithTheirKeyFrameAndJointsMoveBesides) {
  StandingDog dog;
  MtnBytes mtn;
  mtn.locators = {kRightEar, kNeckTilt};
  mtn.key_frames = {{0, {0, 0}}, {7, {1, -100}}, {7, {0, -200}}, {7, {1, -300}}};
  ASSERT_EQ(dog.Start(mtn), "");
  dog.Play();
  EXPECT_EQ(EarsByKeyFrame(dog),
            (std::vector<std::string>{"0: 2/0", "1: 2/2", "2: 2/0", "3: 2/2", "-1: 0/0"}));
  EXPECT_EQ(dog.angle[dog.Joint(kNeckTilt)], -300);
}

TEST(MoverEarsTest, AMotionOfTheEarsAloneTakesItsTime) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kRightEar, {1, 0}, 15)), "");
  dog.Play();
  EXPECT_EQ(dog.frames.size(), 32u);
  EXPECT_EQ(dog.said, (std::vector<std::string>{"mtn", "accepting-commands"}));
  EXPECT_EQ(EarsByKeyFrame(dog).front(), "0: 2/2");
}

TEST(MoverEarsTest, ASingleKeyFrameOfTheEarsIsReported) {
  StandingDog dog;
  ASSERT_EQ(dog.Start(MtnBytes::OneJoint(kRightEar, {1})), "");
  dog.Play();
  EXPECT_EQ(EarsByKeyFrame(dog), (std::vector<std::string>{"-1: 0/0", "0: 2/2", "-1: 0/0"}));
}

// Twenty joints, as the vendor's motions for this robot with mouth, ears and tail have.
TEST(MoverEarsTest, AMotionOfEveryJointAndBothEarsPlays) {
  for (const char* design : {"ERS-210", "ERS-7"}) {
    StandingDog dog(design);
    MtnBytes mtn;
    for (int j = 0; j < dog.robot->numJoints; ++j)
      mtn.locators.push_back(dog.robot->joints[j].locator);
    for (int p = 0; p < dog.robot->numPlungers; ++p)
      mtn.locators.push_back(dog.robot->plungers[p].locator);
    EXPECT_EQ(mtn.locators.size(), 20u);
    std::vector<int32_t> angles;
    for (int j = 0; j < dog.robot->numJoints; ++j) angles.push_back(dog.angle[j]);
    angles.insert(angles.end(), {0, 0});
    mtn.key_frames = {{0, angles}, {0, angles}};
    mtn.key_frames[1].angles_urad[18] = mtn.key_frames[1].angles_urad[19] = 1;
    ASSERT_EQ(dog.Start(mtn), "") << design;
    dog.Play();
    EXPECT_EQ(EarsByKeyFrame(dog), (std::vector<std::string>{"0: 3/0", "1: 3/3", "-1: 0/0"}));
  }
}

}  // namespace
}  // namespace openr_host
