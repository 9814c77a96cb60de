#include "walk.h"

#include <cmath>

#include "virtualrobot/base/det_math.h"

namespace openr_host::motions {
namespace {

// Number of frames in which body and paws move from standing to the stance of the walk, with all
// paws on the floor.
constexpr int kCrouchFrames = 20;

// Number of cycles in which the steps grow to their full length, or shrink to 0.
constexpr int kRampCycles = 1;

double Smooth(double t) { return t * t * (3 - 2 * t); }

// Returns the offset of a paw at `phase` of its cycle; at phase 0 the paw touches the floor.
// `size` scales the step.
PawOffset PawAt(const Gait& gait, double phase, double size) {
  phase -= std::floor(phase);
  const double reach = gait.step_mm * gait.duty * size;  // way of the body while the paw stands
  if (phase < gait.duty) return {reach * (0.5 - phase / gait.duty), 0};
  const double t = (phase - gait.duty) / (1 - gait.duty);
  return {reach * (Smooth(t) - 0.5), gait.lift_mm * size * std::sin(kPi * t) * std::sin(kPi * t)};
}

PawOffsets PawsAt(const Gait& gait, double phase, double size) {
  const PawOffset one = PawAt(gait, phase, size), other = PawAt(gait, phase + 0.5, size);
  return {one, other, other, one};
}

// Returns the stance of the walk: the body is level and lower than in standing, and the paws are
// under its centre of mass.
Stance WalkStance(const Dog& dog, const Gait& gait) {
  Stance stance = dog.StanceOf("stand");
  stance.height_mm = gait.height_mm;
  stance.pitch_rad = 0;
  stance.fore_mm += gait.shift_mm;
  stance.hind_mm += gait.shift_mm;
  return stance;
}

// Returns the phase of the walk in a frame.  The walk begins and ends with all four paws on the
// floor: one diagonal has just been put down, the other is about to be lifted.
double PhaseOf(const Gait& gait, int frame) {
  return (gait.duty - 0.5) / 2 + double(frame) / gait.period_frames;
}

}  // namespace

std::vector<KeyFrame> WalkCycle(const Dog& dog, const Gait& gait) {
  std::vector<KeyFrame> frames;
  for (int f = 0; f <= gait.period_frames; ++f) {
    frames.push_back(dog.FrameOf(WalkStance(dog, gait), PawsAt(gait, PhaseOf(gait, f), 1), "walk"));
  }
  frames.back() = frames.front();
  return frames;
}

std::vector<KeyFrame> WalkStart(const Dog& dog, const Gait& gait) {
  std::vector<KeyFrame> frames{dog.FrameOf("stand")};
  const Stance stand = dog.StanceOf("stand"), walk = WalkStance(dog, gait);
  for (int f = 1; f <= kCrouchFrames; ++f) {
    frames.push_back(
        dog.FrameOf(Blend(stand, walk, Smooth(double(f) / kCrouchFrames)), {}, "walk start"));
  }
  const int ramp = kRampCycles * gait.period_frames;
  for (int f = 1; f <= ramp; ++f) {
    frames.push_back(
        dog.FrameOf(walk, PawsAt(gait, PhaseOf(gait, f), Smooth(double(f) / ramp)), "walk start"));
  }
  return frames;
}

std::vector<KeyFrame> WalkEnd(const Dog& dog, const Gait& gait) {
  std::vector<KeyFrame> frames;
  const Stance walk = WalkStance(dog, gait);
  const int ramp = kRampCycles * gait.period_frames;
  for (int f = 0; f <= ramp; ++f) {
    frames.push_back(dog.FrameOf(walk, PawsAt(gait, PhaseOf(gait, f), Smooth(1 - double(f) / ramp)),
                                 "walk end"));
  }
  const std::vector<KeyFrame> rest =
      dog.Way(dog.PoseOf(walk, "walk end"), dog.PoseOf("stand"), kCrouchFrames, "walk end");
  frames.insert(frames.end(), rest.begin(), rest.end());
  return frames;
}

}  // namespace openr_host::motions
