// The project's own motions, as tools/motions makes them and as objects/common reads them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "MtnFile.h"
#include "dog.h"
#include "leg.h"
#include "openr/motion/mtn_writer.h"
#include "postures.h"
#include "walk.h"

namespace openr_host::motions {
namespace {

const Dog& TheDog() {
  static const Dog dog(OPENR_MODEL_DIR "/ers210.json");
  return dog;
}

MtnFile ReadBack(const std::vector<KeyFrame>& frames) {
  MotionFile motion;
  motion.name = "test#motion";
  motion.locators = TheDog().Locators();
  motion.key_frames = frames;
  const std::vector<uint8_t> bytes = WriteMtn(motion);
  MtnFile file;
  EXPECT_TRUE(file.Read(bytes.data(), bytes.size())) << file.Error();
  EXPECT_TRUE(file.MapTo(&TheDog().robot())) << file.Error();
  EXPECT_TRUE(file.Warnings().empty()) << file.Warnings()[0];
  return file;
}

void ExpectEnds(const std::vector<KeyFrame>& frames, const char* first, const char* last) {
  EXPECT_EQ(frames.front().angles_urad, TheDog().FrameOf(first).angles_urad);
  EXPECT_EQ(frames.back().angles_urad, TheDog().FrameOf(last).angles_urad);
}

TEST(MotionsTest, AllAreReadBackWithoutAWarning) {
  for (const auto& frames :
       {Sit(TheDog()), Stand(TheDog()), Lie(TheDog()), Bow(TheDog()), WalkStart(TheDog(), {}),
        WalkCycle(TheDog(), {}), WalkEnd(TheDog(), {})}) {
    const MtnFile file = ReadBack(frames);
    EXPECT_EQ(file.NumKeyFrames(), static_cast<int>(frames.size()));
    EXPECT_EQ(file.NumJoints(), 15);
  }
}

TEST(MotionsTest, BeginAndEndInThePosturesTheirNamesSay) {
  ExpectEnds(Sit(TheDog()), "stand", "sit");
  ExpectEnds(Stand(TheDog()), "sit", "stand");
  ExpectEnds(Lie(TheDog()), "stand", "sleep");
  ExpectEnds(Bow(TheDog()), "stand", "stand");
}

TEST(MotionsTest, TheWalkChainsFromStandingToStanding) {
  const Gait gait;
  const auto start = WalkStart(TheDog(), gait), cycle = WalkCycle(TheDog(), gait),
             end = WalkEnd(TheDog(), gait);
  EXPECT_EQ(start.front().angles_urad, TheDog().FrameOf("stand").angles_urad);
  EXPECT_EQ(start.back().angles_urad, cycle.front().angles_urad);
  EXPECT_EQ(cycle.back().angles_urad, cycle.front().angles_urad);
  EXPECT_EQ(cycle.back().angles_urad, end.front().angles_urad);
  EXPECT_EQ(end.back().angles_urad, TheDog().FrameOf("stand").angles_urad);
}

TEST(MotionsTest, SlowMotionsKeepNearTheSpeedsOfTheTable) {
  for (const auto& frames : {Sit(TheDog()), Stand(TheDog()), Lie(TheDog()), Bow(TheDog())}) {
    for (size_t k = 1; k < frames.size(); ++k) {
      const double seconds = (frames[k].interpolation + 1) * 0.016;
      for (size_t j = 0; j < frames[k].angles_urad.size(); ++j) {
        const double deg_s = std::abs(frames[k].angles_urad[j] - frames[k - 1].angles_urad[j]) *
                             180e-6 / M_PI / seconds;
        EXPECT_LT(deg_s, 161.25) << "key frame " << k << " joint " << j;
      }
    }
  }
}

TEST(LegTest, ReachesWhatItComputes) {
  const Leg leg({12.8, -64}, {-11.764, -55.854});
  for (const double out : {-40.0, 0.0, 40.0}) {
    for (const double up : {-110.0, -80.0}) {
      const LegPoint paw = leg.Paw(leg.Reach({out, up}, "test"));
      EXPECT_NEAR(paw.out, out, 1e-9);
      EXPECT_NEAR(paw.up, up, 1e-9);
    }
  }
}

TEST(LegTest, APlaceOutOfReachIsRefusedByName) {
  const Leg leg({12.8, -64}, {-11.764, -55.854});
  try {
    leg.Reach({0, -130}, "bow, LF");
    FAIL();
  } catch (const std::domain_error& error) {
    EXPECT_STREQ(
        error.what(),
        "bow, LF: the paw cannot reach 0.0 mm out, -130.0 mm up; the leg is 122.3 mm long");
  }
}

// docs/openr/ers210.md, section 11: pitch -2.6 and height 137.2 standing, 28.0 and 86.2 sitting.
TEST(DogTest, StancesOfPosturesAreThoseOfTheModelsTable) {
  EXPECT_NEAR(TheDog().StanceOf("stand").pitch_rad * 180 / M_PI, -2.6, 0.05);
  EXPECT_NEAR(TheDog().StanceOf("stand").height_mm, 137.2, 0.05);
  EXPECT_NEAR(TheDog().StanceOf("sit").pitch_rad * 180 / M_PI, 28.0, 0.05);
  EXPECT_NEAR(TheDog().StanceOf("sit").height_mm, 86.2, 0.05);
}

TEST(DogTest, AStanceBeyondALimitIsRefusedByJointAndDegrees) {
  Stance low = TheDog().StanceOf("stand");
  low.height_mm = 20;
  EXPECT_THROW(TheDog().FrameOf(low, {}, "test"), std::domain_error);
}

TEST(MtnWriterTest, RefusesAKeyFrameWithoutItsAngles) {
  MotionFile motion;
  motion.locators = {"PRM:/r1/c1-Joint2:j1"};
  motion.key_frames = {{0, {0, 0, 0}, {1, 2}}};
  EXPECT_THROW(WriteMtn(motion), std::invalid_argument);
}

TEST(MtnWriterTest, RefusesANameItsLengthByteCannotSay) {
  MotionFile motion;
  motion.name = std::string(256, 'x');
  EXPECT_THROW(WriteMtn(motion), std::invalid_argument);
}

}  // namespace
}  // namespace openr_host::motions
