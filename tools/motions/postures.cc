#include "postures.h"

#include <string>

#include "virtualrobot/base/det_math.h"

namespace openr_host::motions {
namespace {

// Adds `count` key frames on the way from pose to pose.  Each follows the one before after
// `interpolation` + 1 ticks of 16 ms.
void Go(const Dog& dog, const Dog::Pose& from, const Dog::Pose& to, int count, int interpolation,
        const std::string& what, std::vector<KeyFrame>* frames) {
  for (KeyFrame& frame : dog.Way(from, to, count, what)) {
    frame.interpolation = interpolation;
    frames->push_back(frame);
  }
}

// Adds the key frame of a posture, so that every joint moves straight to its angle.
void GoStraight(const KeyFrame& to, int interpolation, std::vector<KeyFrame>* frames) {
  frames->push_back(to);
  frames->back().interpolation = interpolation;
}

}  // namespace

std::vector<KeyFrame> Sit(const Dog& dog) {
  std::vector<KeyFrame> frames{dog.FrameOf("stand")};
  Go(dog, dog.PoseOf("stand"), dog.PoseOf("sit"), 12, 11, "sit", &frames);
  return frames;
}

// The ERS-7 sits with its weight behind its hind paws and would fall over backwards if it rose from
// there, so it lies down first.
std::vector<KeyFrame> Stand(const Dog& dog) {
  std::vector<KeyFrame> frames{dog.FrameOf("sit")};
  if (dog.is_ers7()) {
    for (const char* const posture : {"sleep", "crouch", "stand"})
      GoStraight(dog.FrameOf(posture), 99, &frames);
    return frames;
  }
  Go(dog, dog.PoseOf("sit"), dog.PoseOf("stand"), 12, 11, "stand", &frames);
  return frames;
}

// Makes the dog lie down: first it bends its legs, then the fore legs slide forward and the hind
// legs fold.
std::vector<KeyFrame> Lie(const Dog& dog) {
  Stance low;
  low.height_mm = dog.is_ers7() ? 100 : 88;
  low.pitch_rad = Radians(3);
  low.fore_mm = 95;
  low.hind_mm = dog.is_ers7() ? -92 : -52;  // nearer, the hind knees would bend too far
  low.tilt_rad = Radians(-20);
  std::vector<KeyFrame> frames{dog.FrameOf("stand")};
  Go(dog, dog.PoseOf("stand"), dog.PoseOf(low, "lie"), 8, 11, "lie", &frames);
  GoStraight(dog.FrameOf("sleep"), 79, &frames);
  return frames;
}

std::vector<KeyFrame> Bow(const Dog& dog) {
  const Dog::Pose stand = dog.PoseOf("stand");
  Stance bowed = stand.stance;
  bowed.height_mm -= 22;
  bowed.pitch_rad = Radians(-15);
  bowed.fore_mm += 12;
  bowed.tilt_rad = Radians(-15);
  const Dog::Pose down = dog.PoseOf(bowed, "bow");
  bowed.tilt_rad = Radians(-45);
  const Dog::Pose nod = dog.PoseOf(bowed, "bow");
  std::vector<KeyFrame> frames{stand.frame};
  Go(dog, stand, down, 8, 9, "bow", &frames);
  Go(dog, down, nod, 2, 14, "bow", &frames);
  Go(dog, nod, down, 2, 14, "bow", &frames);
  Go(dog, down, stand, 8, 9, "bow", &frames);
  return frames;
}

}  // namespace openr_host::motions
