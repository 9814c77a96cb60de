// A trot: the legs of a diagonal swing together, and the two diagonals take turns.
#pragma once

#include <vector>

#include "dog.h"

namespace openr_host::motions {

// Found by trying on the simulated body; all lengths in mm.
struct Gait {
  int period_frames = 40;  // of 16 ms, one full cycle; even
  double step_mm = 56;     // way of the body in one cycle
  double lift_mm = 14;     // of a swinging paw
  double duty = 0.56;      // share of the cycle a paw stands
  double height_mm = 130;  // of the body
  double shift_mm = 8;     // paws ahead of where they stand when standing, to get under the weight
};

// Key frame by key frame at 16 ms.  The start begins in the posture "stand" and ends
// where the cycle begins; the cycle ends where it begins, so it can be looped; the end leads
// from there back to "stand".
std::vector<KeyFrame> WalkStart(const Dog& dog, const Gait& gait);
std::vector<KeyFrame> WalkCycle(const Dog& dog, const Gait& gait);
std::vector<KeyFrame> WalkEnd(const Dog& dog, const Gait& gait);

}  // namespace openr_host::motions
