// A trot: the legs of a diagonal swing together, and the two diagonals take turns.
#pragma once

#include <vector>

#include "dog.h"

namespace openr_host::motions {

// The numbers of the gait, which were found by trials on the simulated body.  Lengths are in mm.
struct Gait {
  int period_frames = 40;  // length of a cycle in frames of 16 ms; even
  double step_mm = 56;     // way of the body in one cycle
  double lift_mm = 14;     // height of a swinging paw
  double duty = 0.56;      // fraction of the cycle in which a paw stands
  double height_mm = 130;  // height of the body
  double shift_mm = 8;     // distance of the paws ahead of their places in standing, which brings
                           // them under the weight
};

// Return key frames every 16 ms.  WalkStart() begins in the posture "stand" and ends where the
// cycle begins.  WalkCycle() ends where it begins, so it can be repeated.  WalkEnd() leads from
// there back to "stand".
std::vector<KeyFrame> WalkStart(const Dog& dog, const Gait& gait);
std::vector<KeyFrame> WalkCycle(const Dog& dog, const Gait& gait);
std::vector<KeyFrame> WalkEnd(const Dog& dog, const Gait& gait);

}  // namespace openr_host::motions
