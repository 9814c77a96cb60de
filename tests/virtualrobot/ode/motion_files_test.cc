// The vendor's own ERS-210 motions on the body.  They may not be part of this project, so
// these tests run only where OPENR_MTN_REFERENCE names a folder that has them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/ode/ode_body.h"

namespace openr_host {
namespace {

// Just enough of a reader for these files: 15 joints, little-endian, key frames in section 3.
struct Motion {
  std::vector<std::vector<double>> keys_rad;  // [key frame][joint of the file]
  std::vector<int> gaps;                      // interpolation count before each but the first
};

constexpr int kFileJoints = 15;

int32_t Word(const std::string& bytes, size_t at) {
  int32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

Motion ReadMotion(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  size_t at = 4;
  for (int section = 0; section < 3; ++section) at += Word(bytes, at + 4);
  at += 12;
  Motion motion;
  while (at + 12 + 4 * kFileJoints <= bytes.size()) {
    if (!motion.keys_rad.empty()) {
      motion.gaps.push_back(Word(bytes, at));
      at += 4;
    }
    at += 12;  // roll, pitch, yaw
    std::vector<double> key_rad;
    for (int j = 0; j < kFileJoints; ++j, at += 4) key_rad.push_back(Word(bytes, at) * 1e-6);
    motion.keys_rad.push_back(key_rad);
  }
  return motion;
}

class MotionFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("OPENR_MTN_REFERENCE");
    if (folder == nullptr || *folder == '\0') GTEST_SKIP() << "OPENR_MTN_REFERENCE names no folder";
    folder_ = folder;
    harness_.Hold(0.1);
  }

  // Moves to the first key frame at a calm speed, then plays: a gap of count n lasts
  // (n + 1) * 16 ms.
  void Play(const std::string& name) {
    const Motion motion = ReadMotion(folder_ + "/" + name + ".MTN");
    ASSERT_GE(motion.keys_rad.size(), 2u) << name;
    std::vector<double> first_rad;
    for (const JointCommand& command : harness_.commands) first_rad.push_back(command.target_rad);
    for (size_t j = 0; j < first_rad.size(); ++j) {
      const int index = Ers210().joints[j].mtn;
      if (index >= 0) first_rad[j] = motion.keys_rad[0][index];
    }
    harness_.RampTo(first_rad);
    for (size_t k = 0; k + 1 < motion.keys_rad.size(); ++k) {
      const int frames = 2 * (motion.gaps[k] + 1);
      for (int i = 1; i <= frames; ++i)
        PlayFrame(motion.keys_rad[k], motion.keys_rad[k + 1], i, frames);
    }
  }

  void PlayFrame(const std::vector<double>& from_rad, const std::vector<double>& to_rad, int i,
                 int frames) {
    for (size_t j = 0; j < harness_.commands.size(); ++j) {
      const int m = Ers210().joints[j].mtn;
      if (m < 0) continue;
      harness_.commands[j].target_rad = from_rad[m] + (to_rad[m] - from_rad[m]) * i / frames;
    }
    harness_.Frame();
  }

  void GoToSleep() {
    harness_.EnableAll();
    harness_.RampTo(harness_.Posture("sleep"));
    harness_.Hold(0.3);
  }

  // |roll| < 20 degrees and pitch within 15 of what kinematics give for the end posture.
  void ExpectRestsAsCommanded(const std::string& what) {
    harness_.Hold(1);
    std::vector<double> angles_rad;
    for (const JointCommand& command : harness_.commands) angles_rad.push_back(command.target_rad);
    const double pitch_deg = Degrees(RpyOf(PlaceOnFloor(Ers210(), angles_rad).X_WB.linear()).y());
    EXPECT_LT(std::fabs(harness_.RpyDegrees().x()), 20) << what;
    EXPECT_NEAR(harness_.RpyDegrees().y(), pitch_deg, 15) << what;
  }

  std::string folder_;
  OdeBody body_{Ers210(), World{}};
  BodyHarness harness_{Ers210(), &body_};
};

TEST_F(MotionFilesTest, SleepToStandEndsStanding) {
  GoToSleep();
  Play("SLPSTAND");
  ExpectRestsAsCommanded("SLPSTAND");
  EXPECT_NEAR(harness_.Position_mm().z(), 137.3, 5);
}

TEST_F(MotionFilesTest, StandToSitEndsSittingUpright) {
  harness_.StandUp();
  Play("STANDSIT");
  ExpectRestsAsCommanded("STANDSIT");
  EXPECT_NEAR(harness_.RpyDegrees().y(), -28, 3);
}

TEST_F(MotionFilesTest, SittingMotionsEndSitting) {
  harness_.StandUp();
  Play("STANDSIT");
  for (const char* name : {"BYEBYE2", "SITCOM01", "SITDNC01", "SITPUR01"}) {
    Play(name);
    ExpectRestsAsCommanded(name);
  }
}

TEST_F(MotionFilesTest, StandingMotionsEndStanding) {
  harness_.StandUp();
  for (const char* name : {"CHEERUP1", "STDBYE01"}) {
    Play(name);
    ExpectRestsAsCommanded(name);
  }
}

TEST_F(MotionFilesTest, LyingMotionsEndLying) {
  GoToSleep();
  for (const char* name : {"RDANCE1", "SLPDNY01"}) {
    Play(name);
    ExpectRestsAsCommanded(name);
  }
}

TEST_F(MotionFilesTest, SitToSleepEndsLying) {
  harness_.StandUp();
  Play("STANDSIT");
  Play("SITSLEEP");
  ExpectRestsAsCommanded("SITSLEEP");
}

TEST_F(MotionFilesTest, WalkGoesForwardAndRoughlyStraight) {
  harness_.StandUp();
  const Eigen::Vector3d start_mm = harness_.Position_mm();
  Play("SWSDK");
  for (int i = 0; i < 5; ++i) Play("WWFWD");
  harness_.Hold(1);
  const Eigen::Vector3d walked_mm = harness_.Position_mm() - start_mm;
  EXPECT_GT(walked_mm.x(), 150);
  EXPECT_LT(std::fabs(walked_mm.y()), 100);
  EXPECT_LT(std::fabs(harness_.RpyDegrees().x()), 20);
}

}  // namespace
}  // namespace openr_host
