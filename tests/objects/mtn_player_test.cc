#include <gtest/gtest.h>

#include "MtnPlayer.h"
#include "mtn_bytes.h"

namespace openr_host {
namespace {

MtnFile Motion(const std::vector<int32_t>& angles_urad, uint32_t interpolation = 0) {
  MtnFile file;
  const std::vector<uint8_t> bytes =
      MtnBytes::OneJoint("PRM:/r1/c1-Joint2:j1", angles_urad, interpolation).Bytes();
  EXPECT_TRUE(file.Read(bytes.data(), bytes.size())) << file.Error();
  return file;
}

struct Vector {
  std::vector<int32_t> urad;  // the only joint, per frame
  int key_frame;              // at its end
  bool operator==(const Vector&) const = default;
};
void PrintTo(const Vector& v, std::ostream* out) {
  *out << "{";
  for (const int32_t urad : v.urad) *out << urad << " ";
  *out << "| kf " << v.key_frame << "}";
}

std::vector<Vector> Play(const MtnFile& motion, int loops = 1, int key_frames_per_vector = 2) {
  MtnPlayer player;
  player.Start(&motion, loops, key_frames_per_vector);
  std::vector<Vector> vectors;
  while (player.IsPlaying()) {
    Vector vector{};
    for (int i = player.FramesOfNextVector(); i > 0; --i) {
      player.NextFrame();
      vector.urad.push_back(player.Position(0));
    }
    vector.key_frame = player.KeyFrame();
    vectors.push_back(vector);
  }
  EXPECT_EQ(player.FramesOfNextVector(), 0);
  return vectors;
}

// Hohl 2004, table 4.2: six key frames, two per vector: ten frames in three vectors, of which
// the last is short.  The second frame of each pair is a key frame.
TEST(MtnPlayerTest, SixKeyFramesTwoPerVectorAreTheTableOfTheReport) {
  EXPECT_EQ(
      Play(Motion({0, 100, 200, 300, 400, 500})),
      (std::vector<Vector>{{{50, 100, 150, 200}, 2}, {{250, 300, 350, 400}, 4}, {{450, 500}, 5}}));
}

TEST(MtnPlayerTest, AnUnevenNumberOfKeyFramesPerVectorIsRoundedDown) {
  const MtnFile motion = Motion({0, 100, 200, 300, 400, 500, 600});
  EXPECT_EQ(Play(motion, 1, 3), Play(motion, 1, 2));
  EXPECT_EQ(Play(motion, 1, 5), Play(motion, 1, 4));
  EXPECT_EQ(Play(motion, 1, 4)[0].urad.size(), 8u);
}

TEST(MtnPlayerTest, NumbersOfKeyFramesThatFitNoVectorAreBroughtIntoRange) {
  const MtnFile motion = Motion(std::vector<int32_t>(20, 0));
  EXPECT_EQ(Play(motion, 1, 1), Play(motion, 1, 2));
  EXPECT_EQ(Play(motion, 1, 0), Play(motion, 1, 2));
  EXPECT_EQ(Play(motion, 1, 100), Play(motion, 1, 8));
  EXPECT_EQ(Play(motion, 1, 8)[0].urad.size(), 16u);
}

TEST(MtnPlayerTest, AGapWithCountNLastsTwoTimesNPlusOneFramesOnAStraightLine) {
  EXPECT_EQ(Play(Motion({0, 600}, 2)), (std::vector<Vector>{{{100, 200, 300, 400, 500, 600}, 1}}));
}

TEST(MtnPlayerTest, AVectorEndsAtAKeyFrameWhenTheNextGapDoesNotFit) {
  const std::vector<Vector> vectors = Play(Motion({0, 1000, 2000, 3000}, 4));  // ten frames each
  ASSERT_EQ(vectors.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(vectors[i].urad.size(), 10u);
    EXPECT_EQ(vectors[i].urad.back(), static_cast<int32_t>(i + 1) * 1000);
    EXPECT_EQ(vectors[i].key_frame, static_cast<int>(i + 1));
  }
}

TEST(MtnPlayerTest, AGapLongerThanAVectorIsSplit) {
  const std::vector<Vector> vectors = Play(Motion({0, 4200, 4300}, 20));  // 42 frames, and 42
  ASSERT_EQ(vectors.size(), 6u);
  EXPECT_EQ(vectors[0].urad.size(), 16u);
  EXPECT_EQ(vectors[0].urad.back(), 1600);
  EXPECT_EQ(vectors[0].key_frame, 0);
  EXPECT_EQ(vectors[1].urad.back(), 3200);
  EXPECT_EQ(vectors[2].urad.size(), 10u);
  EXPECT_EQ(vectors[2].urad.back(), 4200);
  EXPECT_EQ(vectors[2].key_frame, 1);
  EXPECT_EQ(vectors[5].urad.back(), 4300);
}

TEST(MtnPlayerTest, TheLastKeyFrameIsReachedExactlyAlthoughStepsDoNotDivide) {
  EXPECT_EQ(Play(Motion({-1000003, 1999999}, 70)).back().urad.back(), 1999999);
}

TEST(MtnPlayerTest, StepsAreRoundedToTheNearest) {
  EXPECT_EQ(Play(Motion({0, 3})), (std::vector<Vector>{{{2, 3}, 1}}));
  EXPECT_EQ(Play(Motion({0, -3})), (std::vector<Vector>{{{-2, -3}, 1}}));
}

TEST(MtnPlayerTest, FullTurnsDoNotOverflow) {
  const std::vector<Vector> vectors = Play(Motion({-6283186, 6283186}, 3749));
  EXPECT_EQ(vectors[234].urad[5], 0);     // frame 3750 of 7500: half way
  EXPECT_EQ(vectors[234].urad[6], 1676);  // a step of 1675.5 further
}

TEST(MtnPlayerTest, LoopsFollowWithoutAWayBack) {
  EXPECT_EQ(Play(Motion({0, 100, 200}), 2),
            (std::vector<Vector>{{{50, 100, 150, 200}, 2}, {{50, 100, 150, 200}, 2}}));
}

TEST(MtnPlayerTest, ALoopEndsItsVector) {
  EXPECT_EQ(
      Play(Motion({0, 100, 200, 300}), 2),
      (std::vector<Vector>{
          {{50, 100, 150, 200}, 2}, {{250, 300}, 3}, {{50, 100, 150, 200}, 2}, {{250, 300}, 3}}));
}

// field-notes.md, 14.1: recorded walks have nothing between their key frames, and some of these are
// equal.
TEST(MtnPlayerTest, KeyFramesOfLengthZeroArePlayedLikeOthers) {
  EXPECT_EQ(Play(Motion({100, 100, 100, 300}, 0)),
            (std::vector<Vector>{{{100, 100, 100, 100}, 2}, {{200, 300}, 3}}));
}

TEST(MtnPlayerTest, ASingleKeyFrameHasNothingToPlay) { EXPECT_TRUE(Play(Motion({77})).empty()); }

}  // namespace
}  // namespace openr_host
